namespace RayCaster.Engine;

/// <summary>A model as the camera of one picture sees it. It may reject tiles early; the model's own formula decides in which pixels it shows, and
/// at which t.</summary>
internal abstract class ModelView<N> where N : struct, IPacket<N>
{
    /// <summary>Where in the picture the model can show at all.</summary>
    public virtual Tile Extent => Tile.Everywhere;

    /// <summary>A view for one thread at a time; the same object if a view has no state.</summary>
    /// <param name="tools">What the thread's views share; new tools if left out.</param>
    public virtual ModelView<N> ForThread(ThreadTools? tools = null) => this;

    /// <summary>Goes to a tile, before <see cref="Meet"/> is called for its rows; returns the range of the model's hits.</summary>
    public virtual HitRange Enter(in Tile tile, HitRange known) => known;

    /// <summary>Returns the ranges of the model's hits in some parts.</summary>
    public virtual HitRanges Narrow(EightParts parts, HitRange whole) => new(whole);

    /// <summary>Intersects some rays in the tile with the model and keeps hits that are nearer than all before.</summary>
    /// <param name="index">The model's place in the scene, for ties.</param>
    public abstract void Meet(RayStream rays, int index);

    /// <summary>Returns rented memory when the picture is done; called once, not for each thread's view.</summary>
    public virtual void Free()
    {
    }
}
