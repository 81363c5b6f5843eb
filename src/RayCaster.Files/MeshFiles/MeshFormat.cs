namespace RayCaster.Files;

/// <summary>A format of mesh files: how a file is cut into blocks, and how a block is read.</summary>
internal abstract class MeshFormat(MeshSource source, long bodyAt = 0)
{
    private bool hasBegun; // an empty text is a block, too

    protected MeshSource Source => source;

    /// <summary>Where the next block begins.</summary>
    protected long Position { get; set; } = bodyAt;

    /// <summary>Loads the next block; false at the end. Called by one thread at a time, in file order.</summary>
    public virtual bool Next(MeshBlock block)
    {
        if (hasBegun && Position == source.Length) return false;
        (hasBegun, Position) = (true, block.Load(Position, this).End);
        return true;
    }

    /// <summary>Reads a block, while other threads may read other blocks.</summary>
    public abstract void Read(MeshBlock block, MeshBuilder mesh);

    /// <summary>Finds where a block can end.</summary>
    /// <returns>The bytes of the block; 0 where more must be loaded first.</returns>
    public abstract int Cut(ReadOnlySpan<byte> bytes, bool isEnd);
}
