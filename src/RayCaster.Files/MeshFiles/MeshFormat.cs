namespace RayCaster.Files;

/// <summary>A way to write a mesh: how its file is cut into blocks, and how one of them is read.</summary>
internal abstract class MeshFormat
{
    /// <summary>Loads the block behind the last one; false at the end. Called by one thread at a time, in file order.</summary>
    /// <exception cref="MeshFileException">The file cannot be read or is broken.</exception>
    public abstract bool Next(MeshBlock block);

    /// <summary>Reads a block, beside other threads that read other blocks.</summary>
    /// <exception cref="MeshFileException">The block is broken.</exception>
    public abstract void Read(MeshBlock block, MeshBuilder mesh);
}
