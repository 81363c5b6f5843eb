namespace RayCaster.Files;

/// <summary>Why a text is not JSON.</summary>
/// <param name="End">The place after the last byte to underline.</param>
internal readonly record struct JsonMistake(int Start, int End, string Message);
