namespace RayCaster.Files;

/// <summary>A format of mesh files: how a file is cut into blocks, and how a block is read.</summary>
internal abstract class MeshFormat
{
    /// <summary>Loads the next block; false at the end. Called by one thread at a time, in file order.</summary>
    /// <exception cref="MeshFileException">The file cannot be read or is broken.</exception>
    public abstract bool Next(MeshBlock block);

    /// <summary>Reads a block, while other threads may read other blocks.</summary>
    /// <exception cref="MeshFileException">The block is broken.</exception>
    public abstract void Read(MeshBlock block, MeshBuilder mesh);
}
