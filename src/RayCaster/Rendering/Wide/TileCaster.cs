using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>
/// One thread's tool: finds for the pixels of a tile the nearest hits. The tile is halved and halved again, and each part drops the models that
/// cannot show in it; what is left meets the rays.
/// </summary>
internal sealed class TileCaster
{
    /// <summary>Parts of this size are not halved again: a row of it is a few packets, for which a call is still cheap.</summary>
    private const int LeastSide = 16;

    /// <summary>With more models than this a look at what is hidden pays.</summary>
    private const int Crowd = 4;

    private readonly ModelView[] views;
    private readonly Tile[] extents;
    private readonly int[] places;    // of the views' models in the scene
    private readonly CrowdCaster? crowd;
    private readonly RaySpan[] rows = new RaySpan[LeastSide];
    private readonly double[] farthest = new double[LeastSide]; // of each row, the greatest t of the nearest hits so far
    private readonly TileRays rays;
    private ISpanSink sink = null!;
    private readonly List<Candidate>[] candidates = [[], [], []]; // of the tile, its halves and their halves

    /// <param name="frame">What all threads share.</param>
    public TileCaster(Frame frame)
    {
        views = Array.ConvertAll(frame.Views, view => view.ForThread());
        (extents, places) = (frame.Extents, frame.Places);
        if (frame.Crowd is not null) crowd = new(frame.Crowd, frame.Scene.Camera);
        for (var i = 0; i < rows.Length; i++) rows[i] = new(frame.Scene.Camera);
        rays = new(frame.Scene.Camera);
    }

    /// <summary>Casts all rays of a tile.</summary>
    /// <param name="tile">A tile of at most <see cref="Tile.MaxSide"/> pixels a side that does not cross a multiple of it.</param>
    /// <param name="sink">Takes the spans.</param>
    public void Cast(in Tile tile, ISpanSink sink)
    {
        this.sink = sink;
        var list = candidates[0];
        list.Clear();
        rays.Aim(tile);
        var cover = double.PositiveInfinity;
        for (var i = 0; i < views.Length; i++)
        {
            if (!extents[i].Overlaps(tile)) continue;
            var reach = views[i].Enter(rays);
            cover = Math.Min(cover, reach.Cover);
            list.Add(new(i, reach));
        }
        DropHidden(list, cover);
        if (crowd?.IsFor(tile) == true) crowd.Cast(tile, Meet, sink);
        else Descend(tile, 0);

        void Meet(RaySpan span)
        {
            foreach (var candidate in list) views[candidate.Index].Meet(span, places[candidate.Index]);
        }
    }

    /// <summary>Casts a part whose models are known.</summary>
    private void Descend(in Tile part, int level)
    {
        var list = candidates[level];
        if (list.Count <= 1 || level == candidates.Length - 1 || Math.Max(part.Width, part.Height) <= LeastSide)
        {
            CastRows(part, list);
            return;
        }
        var (width, height) = (Half(part.Width), Half(part.Height));
        Descend(new(part.Column, part.Row, width, height), list, level);
        Descend(new(part.Column + width, part.Row, part.Width - width, height), list, level);
        Descend(new(part.Column, part.Row + height, width, part.Height - height), list, level);
        Descend(new(part.Column + width, part.Row + height, part.Width - width, part.Height - height), list, level);
    }

    private void Descend(in Tile part, List<Candidate> whole, int level)
    {
        if (part.Width == 0 || part.Height == 0) return;
        rays.Aim(part);
        var list = candidates[level + 1];
        list.Clear();
        var cover = double.PositiveInfinity;
        foreach (var candidate in whole)
        {
            ref var extent = ref extents[candidate.Index];
            if (!extent.Overlaps(part)) continue;
            var reach = extent.IsSmall ? candidate.Reach : views[candidate.Index].Narrow(rays, candidate.Reach);
            cover = Math.Min(cover, reach.Cover);
            list.Add(candidate with { Reach = reach });
        }
        DropHidden(list, cover);
        Descend(part, level + 1);
    }

    /// <summary>Drops what does not show, or lies behind what covers all.</summary>
    private static void DropHidden(List<Candidate> list, double cover)
    {
        var kept = 0;
        for (var i = 0; i < list.Count; i++)
            if (list[i].Reach.Least <= cover && list[i].Reach.Least < double.PositiveInfinity)
                list[kept++] = list[i];
        list.RemoveRange(kept, list.Count - kept);
    }

    private void CastRows(in Tile part, List<Candidate> list)
    {
        var isCrowded = list.Count > Crowd && part.Height <= rows.Length;
        if (Vector512.IsHardwareAccelerated && isCrowded) CastCrowd<WidePacket>(part, list);
        else if (Vector512.IsHardwareAccelerated) CastRows<WidePacket>(part, list);
        else if (isCrowded) CastCrowd<Packet>(part, list);
        else CastRows<Packet>(part, list);
    }

    /// <summary>Row by row: for few models.</summary>
    private void CastRows<N>(in Tile part, List<Candidate> list) where N : struct, IPacket<N>
    {
        var span = rows[0];
        span.Enter<N>(part.Column, part.Width);
        for (var row = part.Row; row < part.EndRow; row++)
        {
            if (list.Count == 0) span.Clear<N>(row);
            else span.Aim<N>(row);
            foreach (var candidate in list) views[candidate.Index].Meet(span, places[candidate.Index]);
            sink.Take(span);
        }
    }

    /// <summary>Model by model, where there are many and the first hide most of the others.</summary>
    private void CastCrowd<N>(in Tile part, List<Candidate> list) where N : struct, IPacket<N>
    {
        for (var i = 0; i < part.Height; i++)
        {
            rows[i].Enter<N>(part.Column, part.Width);
            rows[i].Aim<N>(part.Row + i);
            farthest[i] = double.PositiveInfinity;
        }
        var farthestOfAll = double.PositiveInfinity;
        foreach (var candidate in list)
        {
            if (candidate.Reach.Least > farthestOfAll) continue;
            ref var extent = ref extents[candidate.Index];
            var end = Math.Min(part.Height, extent.EndRow - part.Row);
            for (var i = Math.Max(0, extent.Row - part.Row); i < end; i++)
            {
                if (candidate.Reach.Least > farthest[i]) continue;
                views[candidate.Index].Meet(rows[i], places[candidate.Index]);
                farthest[i] = rows[i].Farthest<N>();
            }
            farthestOfAll = farthest[0];
            for (var i = 1; i < part.Height; i++) farthestOfAll = Math.Max(farthestOfAll, farthest[i]);
        }
        for (var i = 0; i < part.Height; i++) sink.Take(rows[i]);
    }

    /// <summary>Half of a length of at least <see cref="LeastSide"/>, in whole packets.</summary>
    private static int Half(int length) => length <= LeastSide ? length : (length / 2 + WidePacket.Count - 1) / WidePacket.Count * WidePacket.Count;
}

/// <summary>A model that may show in a tile.</summary>
/// <param name="Index">The place of its view.</param>
/// <param name="Reach">Where its hits lie.</param>
internal readonly record struct Candidate(int Index, Reach Reach);

/// <summary>Takes what tiles come to, a span at a time, in any order and from any thread.</summary>
internal interface ISpanSink
{
    /// <summary>Takes the hits of a span, before the next span is cast into it.</summary>
    void Take(RaySpan span);
}
