namespace RayCaster.Files;

/// <summary>The checksum at the end of a zlib stream (RFC 1950, clause 8).</summary>
internal static class Adler32
{
    /// <summary>The checksum of no bytes.</summary>
    public const uint OfNothing = 1;

    /// <summary>The largest prime below 2^16.</summary>
    private const uint Modulus = 65521;

    /// <summary>So many bytes cannot make the sums overflow.</summary>
    private const int BytesAtOnce = 5552;

    /// <summary>The checksum of what came before and some more bytes.</summary>
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

    /// <summary>The checksum of a part and the rest behind it.</summary>
    /// <remarks>
    /// A checksum is b · 2^16 + a, all modulo 65521, where a is 1 plus the sum of the bytes, and b the sum of the values that a has after each
    /// byte. Behind the first part each of these values is larger than in the rest alone by the sum of the first part's bytes, s = a₁ − 1. So
    /// a = s + a₂, and b = b₁ + b₂ + s · restBytes.
    /// </remarks>
    /// <param name="first">The first part's checksum.</param>
    /// <param name="rest">The rest's checksum.</param>
    /// <param name="restBytes">How many bytes the rest has.</param>
    public static uint Join(uint first, uint rest, long restBytes)
    {
        var s = ((first & 0xFFFF) + Modulus - 1) % Modulus; // a₁ may be 0
        var a = (s + (rest & 0xFFFF)) % Modulus;
        var b = ((first >> 16) + (rest >> 16) + (ulong)s * (ulong)(restBytes % Modulus)) % Modulus;
        return (uint)b << 16 | a;
    }
}
