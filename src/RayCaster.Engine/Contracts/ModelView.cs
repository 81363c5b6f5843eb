namespace RayCaster.Engine;

/// <summary>A model as the camera of one picture sees it. It may say early that it does not show in a tile; which pixels it shows in, and at which
/// t, comes from the model's own formula.</summary>
internal abstract class ModelView<N> where N : struct, IPacket<N>
{
    /// <summary>Where in the picture the model can show at all.</summary>
    public virtual Tile Extent => Tile.Everywhere;

    /// <summary>No hit anywhere in the picture is nearer than this.</summary>
    public virtual double Nearest => 0;

    /// <summary>A view for the use of one thread at a time; the same one where a view keeps nothing between calls.</summary>
    /// <param name="tools">What the thread's views share; new ones if left out.</param>
    public virtual ModelView<N> ForThread(ThreadTools? tools = null) => this;

    /// <summary>Goes to a tile, before <see cref="Meet"/> is called for rows in it, and returns between which t the model's hits lie.</summary>
    /// <param name="known">What is known of that already.</param>
    public virtual HitRange Enter(in Tile tile, HitRange known) => known;

    /// <summary>Returns between which t the model's hits in some parts lie; not called for a model whose <see cref="Extent"/> is small.</summary>
    /// <param name="whole">What is known of all of them.</param>
    public virtual HitRanges Narrow(EightParts parts, HitRange whole) => new(whole);

    /// <summary>Keeps the hits of some pixels in the tile that are nearer than all before.</summary>
    /// <param name="index">The model's place in the scene, for ties.</param>
    public abstract void Meet(RayStream rays, int index);

    /// <summary>Gives rented memory back when the picture is done; called once, on the view that made those of the threads.</summary>
    public virtual void Free()
    {
    }
}
