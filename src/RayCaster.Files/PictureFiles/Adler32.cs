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

    /// <summary>The checksum of two parts together, from the checksum of each.</summary>
    /// <remarks>
    /// A checksum is b · 2^16 + a, both modulo 65521: a is 1 plus the sum of the bytes, and b is the sum of the values of a after each byte.
    /// After the first part, each value of a is larger than in the rest alone by s = a₁ − 1, the sum of the first part's bytes. So
    /// a = s + a₂, and b = b₁ + b₂ + s · restBytes.
    /// </remarks>
    public static uint Join(uint first, uint rest, long restBytes)
    {
        var s = ((first & 0xFFFF) + Modulus - 1) % Modulus; // a₁ may be 0
        var a = (s + (rest & 0xFFFF)) % Modulus;
        var b = ((first >> 16) + (rest >> 16) + (ulong)s * (ulong)(restBytes % Modulus)) % Modulus;
        return (uint)b << 16 | a;
    }
}
