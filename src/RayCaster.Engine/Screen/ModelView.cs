namespace RayCaster.Engine;

/// <summary>A model as the camera of one picture sees it. It may reject tiles early; the model's own formula decides in which pixels it shows, and
/// at which t.</summary>
internal abstract class ModelView
{
    /// <summary>Where in the picture the model can show at all.</summary>
    public virtual PixelRect ShowsIn => PixelRect.Everywhere;

    /// <summary>Whether the model is a single shape with one formula. Only for such a model it pays to cut a tile: <see cref="Narrow"/> then
    /// computes the range of its hits in each part.</summary>
    public virtual bool IsShape => false;

    /// <summary>Whether <see cref="Begin"/> keeps what the other methods need, only until the second next view of this kind that shows enters a
    /// tile.</summary>
    public virtual bool HoldsTile => false;

    /// <summary>A view for one thread at a time; the same object if a view has no state.</summary>
    /// <param name="shared">What the thread's views share; null until the first view that needs it has made it.</param>
    public virtual ModelView ForThread(ref object? shared) => this;

    /// <summary>Sets the tile, before <see cref="Intersect"/> is called for its rows; returns the range of the model's hits.</summary>
    public virtual HitRange Begin(in PixelRect tile, HitRange known) => known;

    /// <summary>Returns the ranges of the model's hits in some parts.</summary>
    public virtual HitRangePacket Narrow(RegionPacket parts, HitRange whole) => new(whole);

    /// <summary>Intersects some rays in the tile with the model and keeps hits that are nearer than all before.</summary>
    /// <param name="index">The model's place in the scene, for ties.</param>
    public abstract void Intersect(RayStream rays, int index);

    /// <summary>Calls the visitor with a single shape and returns what that returns; false for other models.</summary>
    public virtual bool Accept(IShapeVisitor visitor) => false;

    /// <summary>Writes the bytes of the tile that was entered last, in which only this model may show, mostly without exact hits; returns false if
    /// it cannot.</summary>
    /// <param name="first">The position of the lowest row's first pixel.</param>
    /// <param name="step">The distance from a pixel to the one above it.</param>
    public virtual bool Paint(Scene scene, int index, byte[] rgb, int first, int step) => false;

    /// <summary>Returns rented memory when the picture is done; called once, not for each thread's view.</summary>
    public virtual void Free()
    {
    }
}
