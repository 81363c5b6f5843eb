using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;

namespace RayCaster.Files.Tests.Pictures;

/// <summary>PNGs made chunk by chunk, each with its right checksum.</summary>
internal static class TestPng
{
    public static byte[] Png(params byte[][] chunks) => [0x89, .. "PNG\r\n"u8, 0x1A, (byte)'\n', .. chunks.SelectMany(chunk => chunk)];

    /// <summary>The chunk IHDR.</summary>
    public static byte[] Header(int width, int height, byte bitDepth, byte colorType, byte interlacing = 0)
    {
        var data = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(data, width);
        BinaryPrimitives.WriteInt32BigEndian(data.AsSpan(4), height);
        (data[8], data[9], data[12]) = (bitDepth, colorType, interlacing);
        return Chunk("IHDR", data);
    }

    /// <summary>A chunk IDAT of lines, each with its filter before it.</summary>
    public static byte[] Data(params byte[] lines) => Chunk("IDAT", Compress(lines));

    public static byte[] Compress(params byte[] lines)
    {
        var compressed = new MemoryStream();
        using (var compressor = new ZLibStream(compressed, CompressionMode.Compress, leaveOpen: true)) compressor.Write(lines);
        return compressed.ToArray();
    }

    public static byte[] Chunk(string type, params byte[] data)
    {
        byte[] content = [.. Encoding.ASCII.GetBytes(type), .. data], length = new byte[4], checksum = new byte[4];
        BinaryPrimitives.WriteInt32BigEndian(length, data.Length);
        BinaryPrimitives.WriteUInt32BigEndian(checksum, Crc(content));
        return [.. length, .. content, .. checksum];
    }

    /// <summary>CRC-32 bit by bit, as its definition says.</summary>
    private static uint Crc(ReadOnlySpan<byte> data)
    {
        var crc = ~0u;
        foreach (var value in data)
        {
            crc ^= value;
            for (var bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ ((crc & 1) * 0xEDB88320);
        }
        return ~crc;
    }
}
