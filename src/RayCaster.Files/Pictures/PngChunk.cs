namespace RayCaster.Files;

/// <summary>
/// The outer form of a PNG (ISO/IEC 15948, clause 5): a signature, then chunks. A chunk is a length, four letters for its type, data, checksum.
/// </summary>
internal static class PngChunk
{
    /// <summary>Length, type and checksum.</summary>
    public const int Frame = 12;

    private static readonly uint[] crcTable = MakeCrcTable();

    /// <summary>Not ASCII, and with both kinds of line end, so that a transfer as text damages it.</summary>
    public static ReadOnlySpan<byte> Signature => [0x89, (byte)'P', (byte)'N', (byte)'G', (byte)'\r', (byte)'\n', 0x1A, (byte)'\n'];

    public static void Write(Stream output, ReadOnlySpan<byte> type, ReadOnlySpan<byte> data)
    {
        Span<byte> number = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(number, data.Length);
        output.Write(number);
        output.Write(type);
        output.Write(data);
        BinaryPrimitives.WriteUInt32BigEndian(number, Crc(Crc(0, type), data));
        output.Write(number);
    }

    /// <summary>CRC-32 with the polynomial 0xEDB88320 (the specification's annex D). Takes the checksum so far, 0 at first.</summary>
    public static uint Crc(uint crc, ReadOnlySpan<byte> data)
    {
        crc = ~crc;
        foreach (var value in data) crc = crcTable[(byte)(crc ^ value)] ^ (crc >> 8);
        return ~crc;
    }

    private static uint[] MakeCrcTable()
    {
        var table = new uint[256];
        for (var i = 0u; i < table.Length; i++)
        {
            var crc = i;
            for (var bit = 0; bit < 8; bit++) crc = (crc & 1) == 0 ? crc >> 1 : 0xEDB88320 ^ (crc >> 1);
            table[i] = crc;
        }
        return table;
    }
}
