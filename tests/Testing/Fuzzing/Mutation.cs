using System.Buffers.Binary;
using System.Text;

namespace RayCaster.Testing.Fuzzing;

/// <summary>Spoils files: a few steps each, of bytes, of words and brackets, or of a PNG's chunks. The same random numbers give the same
/// file.</summary>
internal sealed class Mutation(Random random, SeedFile[] seeds)
{
    private const int Longest = 1 << 16;

    /// <summary>What stands in files, and what should not.</summary>
    private static readonly string[] words =
    [
        .. "0 -0 1 -1 2 3 0.5 .5 5. +1 00 01 1e 1e400 -1e400 1e308 -1e308 1e-400 5e-324 1e-200 1e200 1e16".Split(' '),
        .. "1e10000000000 0x10 NaN nan Infinity -inf".Split(' '),
        .. "127 128 255 256 65535 65536 1000000 1000001 16777217 2147483647 2147483648 -2147483648 4294967295 4294967296".Split(' '),
        .. "9223372036854775807 9223372036854775808 -9223372036854775808 18446744073709551616".Split(' '),
        .. "179.99999999999997 180 0.1 1.0000000000000002".Split(' '),
        .. "true false null { } [ ] , : \" \\ \\u0000 \\ud800 \\u001b // /* */ # ' ; = \u00fc \u2028 \ufeff \u001b[2J \0".Split(' '),
        .. "camera position target up fovY width height zNear zFar bias clip sample background models type color name $schema".Split(' '),
        .. "plane sphere aabb circle triangle mesh".Split(' '),
        .. "point normal center radius min max a b c file scale rotate translate depth distance corner".Split(' '),
        .. "tetrahedron.obj no.obj ../Good/flat.obj . .. / a\u0000.obj #ff8800 #gggggg {} [] [0,0,0] [1e308,-1e308,1e308] [1e-300,0,0]".Split(' '),
        .. "ply format ascii binary_little_endian binary_big_endian 1.0".Split(' '),
        .. "element property list vertex face edge vertex_indices vertex_index".Split(' '),
        .. "char uchar short ushort int uint float double int8 uint8 float64 x y z end_header comment obj_info".Split(' '),
        .. "v f vt vn o g usemtl 1/2/3 1//3 1/ / //1 -1 -4 solid endsolid facet endfacet outer loop endloop vertex".Split(' '),
        .. "P1 P2 P3 P4 P5 P6 P7 \r \n \r\n \t \v \f".Split(' '),
        new('9', 400), new('9', 5000), "0." + new string('0', 3000) + "1", new('[', 70), new('x', 300), "\"" + new string('y', 3000) + "\"",
    ];

    private static readonly long[] numbers =
    [
        0, 1, -1, 2, 3, 127, 128, 255, 256, 0x7FFF, 0x8000, 0xFFFF, int.MaxValue, int.MinValue, uint.MaxValue, 1L << 32, long.MaxValue,
        long.MinValue,
        0x7F800000, 0xFF800000, 0x7FC00000, 0x00000001, 0x7F7FFFFF, 0x7FF0000000000000, 0x7FEFFFFFFFFFFFFF, 0x7FF8000000000000,
    ];

    /// <summary>A spoilt file.</summary>
    public SeedFile Next()
    {
        var seed = Pick(seeds);
        var bytes = seed.Bytes;
        for (var steps = 1 + random.Next(random.Next(1, 6)); steps > 0; steps--)
        {
            bytes = (seed.Extension == ".png" && random.Next(5) > 0) ? PngMutation.Step(bytes, random, Step) : Step(bytes);
            if (bytes.Length > Longest) bytes = bytes[..Longest];
        }
        return seed with { Bytes = bytes };
    }

    /// <summary>One step that knows nothing of chunks.</summary>
    private byte[] Step(byte[] bytes) => random.Next(16) switch
    {
        0 => Flip(bytes),
        1 => bytes[..random.Next(bytes.Length + 1)],
        2 => Replace(bytes, Range(bytes), []),
        3 => Replace(bytes, At(random.Next(bytes.Length + 1)), Some()),
        4 => Replace(bytes, Range(bytes), Part(Pick(seeds).Bytes)),
        5 => Replace(bytes, Range(bytes), Part(bytes)),
        6 => Repeat(bytes),
        7 or 8 => Poke(bytes),
        9 => Replace(bytes, Brackets(bytes), Part(bytes, Brackets(bytes))),
        10 => Lines(bytes),
        11 => Replace(bytes, Word(bytes), Part(bytes, Word(bytes))),
        12 => Replace(bytes, Word(bytes), []),
        13 => Replace(bytes, At(Word(bytes).Start.Value), Encoding.UTF8.GetBytes(Pick(words) + " ")),
        _ => Replace(bytes, Word(bytes), Encoding.UTF8.GetBytes(Pick(words))),
    };

    private byte[] Flip(byte[] bytes)
    {
        if (bytes.Length == 0) return bytes;
        var copy = (byte[])bytes.Clone();
        for (var count = 1 + random.Next(4); count > 0; count--) copy[random.Next(copy.Length)] ^= (byte)(1 << random.Next(8));
        return copy;
    }

    /// <summary>An extreme number in binary, of any size and order.</summary>
    private byte[] Poke(byte[] bytes)
    {
        var number = new byte[8];
        var value = Pick(numbers);
        if (random.Next(2) == 0) BinaryPrimitives.WriteInt64LittleEndian(number, value);
        else BinaryPrimitives.WriteInt64BigEndian(number, value);
        var size = 1 << random.Next(4);
        var part = random.Next(2) == 0 ? number[..size] : number[(8 - size)..];
        if (bytes.Length < size) return bytes;
        var copy = (byte[])bytes.Clone();
        part.CopyTo(copy.AsSpan(random.Next(3) == 0 ? random.Next(Math.Min(100, bytes.Length - size + 1)) : random.Next(bytes.Length - size + 1)));
        return copy;
    }

    private byte[] Repeat(byte[] bytes)
    {
        var range = random.Next(2) == 0 ? Brackets(bytes) : Range(bytes);
        var part = bytes[range];
        if (part.Length == 0) return bytes;
        var times = Math.Min(1 + random.Next(1, 2000) / (1 + random.Next(20)), Longest / part.Length);
        return Replace(bytes, At(range.End.Value), [.. Enumerable.Repeat(part, times).SelectMany(copy => copy)]);
    }

    private byte[] Lines(byte[] bytes)
    {
        var from = bytes.AsSpan(0, random.Next(bytes.Length + 1)).LastIndexOf((byte)'\n') + 1;
        var length = bytes.AsSpan(from).IndexOf((byte)'\n') + 1;
        var line = bytes[from..(from + length)];
        var to = bytes.AsSpan(0, random.Next(bytes.Length + 1)).LastIndexOf((byte)'\n') + 1;
        return random.Next(3) switch
        {
            0 => Replace(bytes, from..(from + length), []),
            1 => Replace(bytes, At(to), line),
            _ => Replace(bytes, from..(from + length), [.. line, .. line]),
        };
    }

    /// <summary>A word, or one character that separates words.</summary>
    private Range Word(byte[] bytes)
    {
        if (bytes.Length == 0) return At(0);
        var at = random.Next(3) == 0 ? random.Next(Math.Min(400, bytes.Length)) : random.Next(bytes.Length); // headers are short
        if (IsSeparator(bytes[at])) return at..(at + 1);
        var (start, end) = (at, at);
        while (start > 0 && !IsSeparator(bytes[start - 1])) start--;
        while (end < bytes.Length && !IsSeparator(bytes[end])) end++;
        return start..end;
    }

    /// <summary>A bracket and all up to the one that closes it.</summary>
    private Range Brackets(byte[] bytes)
    {
        var from = random.Next(bytes.Length + 1);
        var way = bytes.AsSpan(from).IndexOfAny((byte)'{', (byte)'[');
        if (way < 0) return Range(bytes);
        var (start, depth) = (from + way, 0);
        for (var end = start; end < bytes.Length; end++)
        {
            if (bytes[end] is (byte)'{' or (byte)'[') depth++;
            if (bytes[end] is (byte)'}' or (byte)']' && --depth == 0) return start..(end + 1);
        }
        return start..bytes.Length;
    }

    private Range Range(byte[] bytes)
    {
        var start = random.Next(bytes.Length + 1);
        var length = Math.Min(random.Next(1 + random.Next(random.Next(2) == 0 ? 8 : 300)), bytes.Length - start);
        return start..(start + length);
    }

    private byte[] Part(byte[] bytes) => bytes[Range(bytes)];

    private static byte[] Part(byte[] bytes, Range range) => bytes[range];

    private byte[] Some()
    {
        var bytes = new byte[random.Next(20)];
        random.NextBytes(bytes);
        return bytes;
    }

    private T Pick<T>(T[] all) => all[random.Next(all.Length)];

    private static Range At(int place) => place..place;

    private static byte[] Replace(byte[] bytes, Range range, byte[] by) => [.. bytes[..range.Start], .. by, .. bytes[range.End..]];

    private static bool IsSeparator(byte value) => value <= ' ' || "{}[],:\"/".Contains((char)value);
}
