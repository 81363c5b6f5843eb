namespace RayCaster.Teaching.Visibility;

/// <summary>
/// PFM, the portable float map. The header has three lines: "Pf" for one number per pixel; width and height; and a scale, negative for
/// little-endian. Then follow 32-bit floats, the bottom line first.
/// </summary>
public static class PfmFile
{
    /// <summary>Writes a map, little-endian (scale −1.0).</summary>
    /// <param name="output">Where the bytes go; stays open.</param>
    public static void Write(Stream output, NumberMap map)
    {
        output.Write(Encoding.ASCII.GetBytes($"Pf\n{map.Width} {map.Height}\n-1.0\n"));
        for (var y = map.Height - 1; y >= 0; y--) output.Write(MemoryMarshal.AsBytes(map.Values.AsSpan(y * map.Width, map.Width)));
    }
}
