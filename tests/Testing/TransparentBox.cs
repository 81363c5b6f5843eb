namespace RayCaster.Testing;

/// <summary>A right picture that no viewer shows: its file's alpha is 0 everywhere.</summary>
internal static class TransparentBox
{
    public const string Told = "The file's alpha is 0 in every pixel";

    public const string Scene = """
        {"camera": {"position": [20, 0, 0], "target": [0, 0, 0], "width": 6, "height": 4},
        "models": [{"type": "aabb", "min": [-1, -4, -4], "max": [1, 4, 4], "color": [1, 0.7, 0]}]}
        """;

    /// <summary>The file in base 64.</summary>
    public const string Png =
        "iVBORw0KGgoAAAANSUhEUgAAAAYAAAAECAYAAACtBE5DAAAAH0lEQVR42mNggILGKAaG5hgIjQJAgm1xEBoF4NSBDgDgpQfN+zp6BQAAAABJRU5ErkJggg==";

    public static byte[] Bytes => Convert.FromBase64String(Png);
}
