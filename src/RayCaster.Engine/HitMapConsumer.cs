namespace RayCaster.Engine;

/// <summary>One thread's consumer of hits that writes them into a map.</summary>
internal sealed class HitMapConsumer<N>(HitMap map, Camera camera) : IHitConsumer where N : struct, IPacket<N>
{
    private readonly CoveredHits<N> coveredHits = new(camera);

    public void Consume(RayStream rays)
    {
        for (var i = 0; i < rays.Rows; i++)
        {
            var first = IndexOf(rays.Column, rays.Row + i);
            rays.T.Slice(i * rays.Pitch, rays.Width).CopyTo(map.T.AsSpan(first));
            rays.CopyModels(i * rays.Pitch, map.Model.AsSpan(first, rays.Width));
        }
    }

    public void FillBackground(in PixelRect part)
    {
        for (var row = part.Row; row < part.EndRow; row++) map.T.AsSpan(IndexOf(part.Column, row), part.Width).Fill(double.PositiveInfinity);
        FillModels(part, -1);
    }

    public bool PaintCovered(in CoveredTile covered)
    {
        if (!coveredHits.Write(covered, map.T, IndexOf(covered.Part.Column, covered.Part.Row), -map.Width)) return false;
        FillModels(covered.Part, covered.Index);
        return true;
    }

    public bool PaintMesh(in PixelRect tile, ModelView view, int index) => false; // bytes without exact hits are of no use here

    private void FillModels(in PixelRect part, int index)
    {
        for (var row = part.Row; row < part.EndRow; row++) map.Model.AsSpan(IndexOf(part.Column, row), part.Width).Fill(index);
    }

    private int IndexOf(int column, int row) => (map.Height - 1 - row) * map.Width + column;
}
