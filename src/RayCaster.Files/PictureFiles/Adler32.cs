namespace RayCaster.Files;

/// <summary>The checksum at the end of a zlib stream (RFC 1950, clause 8).</summary>
internal static class Adler32
{
    public const uint OfNothing = 1;

    /// <summary>The largest prime below 2^16.</summary>
    private const uint Modulus = 65521;

    /// <summary>The sums of this many bytes cannot overflow.</summary>
    private const int BytesAtOnce = 5552;

    public static uint Add(uint sum, ReadOnlySpan<byte> bytes)
    {
        var (a, b) = (sum & 0xFFFF, sum >> 16);
        while (!bytes.IsEmpty)
        {
            var part = bytes[..Math.Min(bytes.Length, BytesAtOnce)];
            foreach (var value in part)
            {
                a += value;
                b += a;
            }
            (a, b) = (a % Modulus, b % Modulus);
            bytes = bytes[part.Length..];
        }
        return b << 16 | a;
    }
}
