namespace RayCaster.Files;

/// <summary>A number of things, for messages.</summary>
internal static class Plural
{
    /// <summary><c>1 vertex</c>, <c>1,000 vertices</c>.</summary>
    public static string Format(long count, string what) =>
        FormattableString.Invariant($"{count:N0} {(count == 1 ? what : what == "vertex" ? "vertices" : what + "s")}");
}
