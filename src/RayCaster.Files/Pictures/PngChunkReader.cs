namespace RayCaster.Files;

/// <summary>Reads the chunks of a PNG in order, and the data of each in pieces of any size, so that no chunk need fit into memory.</summary>
internal sealed class PngChunkReader
{
    private readonly Stream file;
    private readonly byte[] frame = new byte[8], scratch = new byte[1 << 14];
    private uint crc;

    public PngChunkReader(Stream file)
    {
        if (!file.CanSeek) throw new ProblemException("it is a pipe or a device; name a file");
        this.file = file;
        file.Position = 0;
        if (Fill(frame) == 0) throw new ProblemException("the file is empty");
        if (frame[0] != PngChunk.Signature[0]) throw new ProblemException("it is not a PNG");
        if (!frame.AsSpan().SequenceEqual(PngChunk.Signature))
            throw new ProblemException("it begins like a PNG, but its first eight bytes are damaged; was it written or transferred as text? "
                + "Open the file in binary mode");
    }

    public string Type { get; private set; } = "";

    public long Place { get; private set; }

    public long Left { get; private set; }

    /// <summary>Whether the chunk's checksum is wrong. That is an error unless the pixels do not need the chunk.</summary>
    public bool IsDamaged { get; private set; }

    public void Next()
    {
        Place = file.Position;
        var follow = file.Length - Place - PngChunk.Frame;
        if (follow < 0 || Fill(frame) < frame.Length)
            throw new ProblemException($"the file is cut short: it ends at byte {file.Length:N0}, before its chunk IEND");
        Left = BinaryPrimitives.ReadUInt32BigEndian(frame);
        foreach (var letter in frame.AsSpan(4))
            if (!char.IsAsciiLetter((char)letter))
                throw new ProblemException($"its chunk at byte {Place:N0} is of the type {PictureFile.Printable(frame.AsSpan(4))}, " +
                    "which is not four letters");
        Type = Encoding.ASCII.GetString(frame.AsSpan(4));
        if (Left > follow)
            throw new ProblemException(
                $"the file is cut short: its chunk {Type} at byte {Place:N0} needs {Left:N0} bytes, but {follow:N0} follow");
        crc = PngChunk.Crc(0, frame.AsSpan(4));
        if (Left == 0) CheckCrc();
    }

    public void Return(long chunk)
    {
        file.Position = chunk;
        Next();
    }

    /// <summary>Reads the next bytes of the chunk's data, and checks the checksum after the last of them.</summary>
    /// <returns>How many: fewer than the buffer holds only at the chunk's end.</returns>
    public int Read(Span<byte> buffer)
    {
        if (Left == 0) return 0;
        var data = buffer[..(int)Math.Min(buffer.Length, Left)];
        if (Fill(data) < data.Length) throw new ProblemException("the file became shorter while it was read");
        crc = PngChunk.Crc(crc, data);
        Left -= data.Length;
        if (Left == 0) CheckCrc();
        return data.Length;
    }

    public byte[] ReadUpTo(int most)
    {
        var data = new byte[Math.Min(most, Left)];
        Read(data);
        return data;
    }

    /// <summary>Reads the rest of the chunk only to check the checksum.</summary>
    public void Check()
    {
        while (Left > 0) Read(scratch);
    }

    public void Skip()
    {
        if (Left == 0) return; // the checksum was read already
        file.Position += Left + 4;
        Left = 0;
    }

    private void CheckCrc()
    {
        var sum = frame.AsSpan(0, 4);
        if (Fill(sum) < 4) throw new ProblemException("the file became shorter while it was read");
        IsDamaged = BinaryPrimitives.ReadUInt32BigEndian(sum) != crc;
        if (IsDamaged && char.IsAsciiLetterUpper(Type[0])) // needed for the pixels
            throw new ProblemException($"its chunk {Type} at byte {Place:N0} is damaged: the checksum is wrong");
    }

    private int Fill(Span<byte> buffer)
    {
        try
        {
            return file.ReadAtLeast(buffer, buffer.Length, throwOnEndOfStream: false);
        }
        catch (IOException e)
        {
            throw ProblemException.From(e); // an IOException would be taken for damaged data
        }
    }
}
