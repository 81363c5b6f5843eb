using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;

namespace RayCaster.Testing.Fuzzing;

/// <summary>Corrupts the content of PNG chunks and corrects their checksums; with wrong checksums the content would never be read.</summary>
internal static class PngMutation
{
    private static readonly string[] types = ["IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA", "tEXt", "ABCD", "\0\0\0\0", "idat"];

    private static readonly uint[] sizes =
        [0, 1, 2, 3, 7, 8, 9, 255, 256, 65535, 65536, 1 << 24, 1 << 27, (1 << 27) + 1, int.MaxValue, 1u << 31, uint.MaxValue];

    /// <param name="file">The file; what is no PNG is changed as any other.</param>
    /// <param name="random">What decides.</param>
    /// <param name="inner">Changes bytes.</param>
    public static byte[] Step(byte[] file, Random random, Func<byte[], byte[]> inner)
    {
        if (Chunks(file) is not { Count: > 0 } chunks) return inner(file);
        var (at, other) = (random.Next(chunks.Count), random.Next(chunks.Count));
        var (type, data) = chunks[at];
        switch (random.Next(9))
        {
            case 0:
                chunks.RemoveAt(at);
                break;
            case 1:
                chunks.Insert(other, chunks[at]);
                break;
            case 2:
                (chunks[at], chunks[other]) = (chunks[other], chunks[at]);
                break;
            case 3:
                chunks[at] = (types[random.Next(types.Length)], data);
                break;
            case 4:
                chunks[at] = (type, inner(data));
                break;
            case 5 when data.Length > 1: // in two
                var cut = random.Next(data.Length);
                chunks[at] = (type, data[..cut]);
                chunks.Insert(at + 1, (type, data[cut..]));
                break;
            case 6 when chunks[0].Data.Length >= 13:
                var header = (byte[])chunks[0].Data.Clone();
                if (random.Next(2) == 0) header[random.Next(8, 13)] = (byte)random.Next(random.Next(2) == 0 ? 20 : 256);
                else BinaryPrimitives.WriteUInt32BigEndian(header.AsSpan(4 * random.Next(2)), sizes[random.Next(sizes.Length)]);
                chunks[0] = (chunks[0].Type, header);
                break;
            default: // the pixels, before they are compressed
                if (chunks.FindIndex(chunk => chunk.Type == "IDAT") is not (>= 0 and var pixels)
                    || Decompressed(chunks[pixels].Data) is not { } lines) break;
                chunks[pixels] = ("IDAT", Compressed(inner(lines)));
                break;
        }
        var result = new MemoryStream();
        result.Write(PngChunk.Signature);
        foreach (var chunk in chunks) PngChunk.Write(result, Encoding.Latin1.GetBytes(chunk.Type), chunk.Data);
        return result.ToArray();
    }

    public static List<(string Type, byte[] Data)> Chunks(byte[] file)
    {
        var chunks = new List<(string, byte[])>();
        for (var at = 8; at <= file.Length - PngChunk.Frame;)
        {
            var length = BinaryPrimitives.ReadUInt32BigEndian(file.AsSpan(at));
            if (length > file.Length - at - PngChunk.Frame) break;
            chunks.Add((Encoding.Latin1.GetString(file, at + 4, 4), file.AsSpan(at + 8, (int)length).ToArray()));
            at += PngChunk.Frame + (int)length;
        }
        return chunks;
    }

    private static byte[]? Decompressed(byte[] data)
    {
        try
        {
            using var stream = new ZLibStream(new MemoryStream(data), CompressionMode.Decompress);
            var lines = new byte[1 << 16];
            return lines[..stream.ReadAtLeast(lines, lines.Length, throwOnEndOfStream: false)];
        }
        catch (Exception e) when (e is InvalidDataException or IOException)
        {
            return null;
        }
    }

    private static byte[] Compressed(byte[] lines)
    {
        var data = new MemoryStream();
        using (var stream = new ZLibStream(data, CompressionLevel.Fastest, leaveOpen: true)) stream.Write(lines);
        return data.ToArray();
    }
}
