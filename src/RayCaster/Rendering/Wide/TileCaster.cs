using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>
/// One thread's tool: finds for the pixels of a tile the nearest hits. The tile is halved and halved again, and each part drops the models that
/// cannot show in it; what is left meets the rays.
/// </summary>
internal sealed class TileCaster : IStripCaster
{
    /// <summary>Parts of this size are not halved again: a row of it is a few packets, for which a call is still cheap.</summary>
    private const int LeastSide = 16;

    /// <summary>With more models than this a look at what is hidden pays.</summary>
    private const int Crowd = 4;

    private readonly Frame frame;
    private readonly ModelView[] views;
    private readonly Tile[] extents;
    private readonly int[] places; // of the views' models in the scene
    private readonly CrowdCaster? crowd;
    private readonly RaySpan[] rows = new RaySpan[LeastSide];
    private readonly double[] farthest = new double[LeastSide]; // of each row, the greatest t of the nearest hits so far
    private readonly CoveredPart covered;
    private readonly RaySpan block;
    private readonly Predicate<Candidate> isPrimitive;
    private ISpanSink sink = null!;
    private readonly List<Candidate> candidates = []; // of the strip
    private readonly FourParts[] parts;               // the strip's tiles, a tile's quarters, and a quarter's
    private readonly List<Candidate>[][] narrowed = [[[], [], [], []], [[], [], [], []], [[], [], [], []]]; // of each of these

    /// <param name="frame">What all threads share.</param>
    public TileCaster(Frame frame)
    {
        this.frame = frame;
        views = Array.ConvertAll(frame.Views, view => view.ForThread());
        (extents, places) = (frame.Extents, frame.Places);
        if (frame.Crowd is not null) crowd = new(frame.Crowd, frame.Scene.Camera);
        for (var i = 0; i < rows.Length; i++) rows[i] = new(frame.Scene.Camera);
        parts = [new(frame.Scene.Camera), new(frame.Scene.Camera), new(frame.Scene.Camera)];
        covered = new(frame);
        block = new(frame.Scene.Camera, RaySpan.MaxArea);
        isPrimitive = candidate => views[candidate.Index] is ICoveringView;
    }

    /// <inheritdoc/>
    public void Cast(in Tile strip, ISpanSink sink)
    {
        this.sink = sink;
        candidates.Clear();
        for (var i = 0; i < views.Length; i++)
            if (extents[i].Overlaps(strip))
                candidates.Add(new(i, new(views[i].Nearest, double.PositiveInfinity)));
        parts[0].Split(strip);
        Narrow(parts[0], candidates, narrowed[0]);
        if (crowd?.IsFor(strip) != true && OneModel(parts[0], narrowed[0]) is { } only) Cover(strip, only);
        else
            for (var i = 0; i < FourParts.Count; i++)
                if (parts[0][i].Area > 0)
                    Cast(parts[0][i], narrowed[0][i]);
    }

    /// <summary>Casts a tile.</summary>
    private void Cast(in Tile tile, List<Candidate> list)
    {
        var cover = double.PositiveInfinity;
        for (var i = 0; i < list.Count; i++)
        {
            var reach = views[list[i].Index].Enter(tile, list[i].Reach);
            cover = Math.Min(cover, reach.Cover);
            list[i] = list[i] with { Reach = reach };
        }
        DropHidden(list, cover);
        if (crowd?.IsFor(tile) == true) crowd.Cast(tile, list.Count > 0 ? Meet : null, sink);
        else if (list.Count == 1 && views[list[0].Index] is IPaintingView) CastAlone(tile, list);
        else Descend(tile, list, 1);

        void Meet(RaySpan span)
        {
            foreach (var candidate in list) views[candidate.Index].Meet(span, places[candidate.Index]);
        }
    }

    /// <summary>Casts a tile in which one model alone may show, of which halving the tile would tell no more.</summary>
    private void CastAlone(in Tile tile, List<Candidate> list)
    {
        var only = list[0].Index;
        if (!(frame.IsLong && sink.TryTake(tile, views[only], places[only]))) CastRows(tile, list);
    }

    /// <summary>Casts a part whose models are known.</summary>
    private void Descend(in Tile part, List<Candidate> list, int level)
    {
        if (list.Count == 0) sink.TakeMiss(part);
        else if (IsCovered(list)) Cover(part, list[0]);
        else if (level == parts.Length || Math.Max(part.Width, part.Height) <= LeastSide) CastRows(part, list);
        else
        {
            var (quarters, lists) = (parts[level], narrowed[level]);
            quarters.Quarter(part);
            Narrow(quarters, list, lists);
            if (OneModel(quarters, lists) is { } only) Cover(part, only);
            else
                for (var i = 0; i < FourParts.Count; i++)
                    if (quarters[i].Area > 0)
                        Descend(quarters[i], lists[i], level + 1);
        }
    }

    /// <summary>Finds out which models may show in which part.</summary>
    private void Narrow(FourParts parts, List<Candidate> whole, List<Candidate>[] lists)
    {
        Span<double> covers = [double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity];
        foreach (var list in lists) list.Clear();
        foreach (var candidate in whole)
        {
            ref var extent = ref extents[candidate.Index];
            var reaches = extent.IsSmall ? new(candidate.Reach) : views[candidate.Index].Narrow(parts, candidate.Reach);
            for (var i = 0; i < FourParts.Count; i++)
            {
                if (!extent.Overlaps(parts[i])) continue;
                var reach = reaches[i];
                covers[i] = Math.Min(covers[i], reach.Cover);
                lists[i].Add(candidate with { Reach = reach });
            }
        }
        for (var i = 0; i < FourParts.Count; i++) DropHidden(lists[i], covers[i]);
    }

    /// <summary>Whether every ray's first hit is surely one of the same model, which knows the short way.</summary>
    private bool IsCovered(List<Candidate> list) =>
        frame.IsLong && list.Count == 1 && list[0].Reach.Cover < double.PositiveInfinity && views[list[0].Index] is ICoveringView;

    /// <summary>The model that covers all parts, if one does.</summary>
    private Candidate? OneModel(FourParts parts, List<Candidate>[] lists)
    {
        if (!IsCovered(lists[0])) return null;
        var only = lists[0][0];
        for (var i = 1; i < FourParts.Count; i++)
        {
            if (parts[i].Area == 0) continue;
            if (!IsCovered(lists[i]) || lists[i][0].Index != only.Index) return null;
            if (!lists[i][0].Reach.IsNear) only = only with { Reach = lists[i][0].Reach };
        }
        return only;
    }

    private void Cover(in Tile part, Candidate only)
    {
        covered.Enter(part, only.Reach.IsNear);
        sink.TakeCover(covered, views[only.Index], places[only.Index]);
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
        if (list.Count <= Crowd && part.Area <= RaySpan.MaxArea && part.Width % WidePacket.Count == 0 && list.TrueForAll(isPrimitive))
        {
            if (Vector512.IsHardwareAccelerated) CastAtOnce<WidePacket>(part, list);
            else CastAtOnce<Packet>(part, list);
            return;
        }
        var isCrowded = list.Count > Crowd && part.Height <= rows.Length;
        if (Vector512.IsHardwareAccelerated && isCrowded) CastCrowd<WidePacket>(part, list);
        else if (Vector512.IsHardwareAccelerated) CastRows<WidePacket>(part, list);
        else if (isCrowded) CastCrowd<Packet>(part, list);
        else CastRows<Packet>(part, list);
    }

    /// <summary>All rows at once: for few models in a small part.</summary>
    private void CastAtOnce<N>(in Tile part, List<Candidate> list) where N : struct, IPacket<N>
    {
        block.Enter<N>(part.Column, part.Width);
        block.Aim<N>(part.Row, part.Height);
        foreach (var candidate in list) views[candidate.Index].Meet(block, places[candidate.Index]);
        sink.Take(block);
    }

    /// <summary>Row by row: for few models.</summary>
    private void CastRows<N>(in Tile part, List<Candidate> list) where N : struct, IPacket<N>
    {
        var span = rows[0];
        span.Enter<N>(part.Column, part.Width);
        for (var row = part.Row; row < part.EndRow; row++)
        {
            span.Aim<N>(row);
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
}
