namespace RayCaster.Files;

/// <summary>Why a text is not JSON.</summary>
/// <param name="Start">The place of the first wrong byte.</param>
/// <param name="End">The place after the last byte to underline.</param>
/// <param name="Message">What is wrong and what to do.</param>
internal readonly record struct JsonMistake(int Start, int End, string Message);
