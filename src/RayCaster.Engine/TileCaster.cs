namespace RayCaster.Engine;

/// <summary>Finds the nearest hits for the pixels of a tile; each thread has its own. A strip is cut into tiles, and a tile in which several models
/// may show into small parts. Each step drops the models that cannot show; the rays are intersected with the rest.</summary>
internal sealed class TileCaster<N> where N : struct, IPacket<N>
{
    /// <summary>The side of a small part: a row of it is a few packets, for which a call is still cheap.</summary>
    private const int PartSide = 16;

    private const int PartsAcross = Tile.MaxSide / PartSide, PartsUp = RegionPacket.Count / PartsAcross;

    private readonly RenderContext<N> context;
    private readonly ModelView[] views;
    private readonly PixelRect[] showIn;
    private readonly int[] modelIndices; // of the views' models in the scene
    private readonly BatchCaster<N>? batch;
    private readonly RayStream rays;
    private RayStream? ofMeshes; // all rays of a tile, and what they hit where several meshes show
    private bool hasSeveralMeshes;
    private readonly Predicate<Candidate> isShape;
    private IHitConsumer consumer = null!;
    private readonly List<Candidate> candidates = []; // of the strip
    private readonly RegionPacket tiles, parts;         // the strip's, and some of a tile
    private readonly List<Candidate>[] ofTiles = [[], [], [], [], [], [], [], []], ofParts = [[], [], [], [], [], [], [], []];

    public TileCaster(RenderContext<N> context)
    {
        this.context = context;
        object? shared = null;
        views = Array.ConvertAll(context.Views, view => view.ForThread(ref shared));
        (showIn, modelIndices) = (context.ShowIn, context.ModelIndices);
        if (context.PrimitiveBatch is not null) batch = new(context.PrimitiveBatch, context.Scene.Camera);
        rays = new(context.Scene.Camera, RayStream.MaxArea);
        (tiles, parts) = (new(context.Scene.Camera), new(context.Scene.Camera));
        isShape = candidate => views[candidate.Index].IsShape;
    }

    /// <inheritdoc cref="StripCaster"/>
    public void Cast(in PixelRect strip, IHitConsumer consumer)
    {
        this.consumer = consumer;
        candidates.Clear();
        for (var i = 0; i < views.Length; i++)
            if (showIn[i].Overlaps(strip))
                candidates.Add(new(i, new(0, double.PositiveInfinity))); // nothing is known yet
        tiles.Cut(strip, Tile.MaxSide, RegionPacket.Count);
        Narrow(tiles, candidates, ofTiles);
        var areAllKnown = batch?.IsFor(strip) != true;
        for (var i = 0; i < RegionPacket.Count; i++)
        {
            if (tiles[i].Area == 0) continue;
            if (areAllKnown && MergeUniform(tiles, ofTiles, i) is > 0 and var count) i += count - 1;
            else Cast(tiles[i], ofTiles[i]);
        }
    }

    private void Cast(in PixelRect tile, List<Candidate> list)
    {
        var (farthestT, last) = (double.PositiveInfinity, -1); // the last mesh that shows
        for (var i = 0; i < list.Count; i++)
        {
            var view = views[list[i].Index];
            var range = view.Begin(tile, list[i].Range);
            farthestT = Math.Min(farthestT, range.FarthestT);
            list[i] = list[i] with { Range = range };
            if (!view.HoldsTile || range == HitRange.None) continue;
            if (last >= 0) IntersectMesh(tile, list, last, farthestT);
            last = i;
        }
        if (hasSeveralMeshes) IntersectMesh(tile, list, last, farthestT);
        DropHidden(list, farthestT);
        if (batch?.IsFor(tile) == true) CastBatch(batch, tile, list);
        else if (hasSeveralMeshes && list.Count == 0) consumer.Consume(ofMeshes!);
        else if (list.Count == 1 && !isShape(list[0]) && !hasSeveralMeshes) CastAlone(tile, list);
        else Cut(tile, list);
        hasSeveralMeshes = false;
    }

    /// <summary>Intersects all rays of a tile with one of several meshes, since its view will not hold its pixels; then it is no candidate any
    /// more.</summary>
    private void IntersectMesh(in PixelRect tile, List<Candidate> list, int place, double farthestT)
    {
        var (index, range) = list[place];
        list[place] = new(index, HitRange.None);
        if (range.NearestT > farthestT) return;
        if (!hasSeveralMeshes)
        {
            ofMeshes ??= new(context.Scene.Camera, Tile.MaxSide * Tile.MaxSide);
            ofMeshes.Begin<N>(tile.Column, tile.Width, Tile.MaxSide);
            ofMeshes.Aim<N>(tile.Row, tile.Height);
            hasSeveralMeshes = true;
        }
        views[index].Intersect(ofMeshes!, modelIndices[index]);
    }

    private void CastBatch(BatchCaster<N> batch, in PixelRect tile, List<Candidate> list)
    {
        batch.Cast(tile, list.Count > 0 || hasSeveralMeshes ? Intersect : null, consumer);

        void Intersect(RayStream rays)
        {
            if (hasSeveralMeshes) rays.CopyHits<N>(ofMeshes!);
            foreach (var candidate in list) views[candidate.Index].Intersect(rays, modelIndices[candidate.Index]);
        }
    }

    /// <summary>Casts a tile in which only one model may show that is no single shape: cutting it would tell no more.</summary>
    private void CastAlone(in PixelRect tile, List<Candidate> list)
    {
        var only = list[0].Index;
        if (!(context.Plan.UsesShapeKernels && consumer.PaintMesh(tile, views[only], modelIndices[only]))) CastRows(tile, list);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Cut(in PixelRect tile, List<Candidate> list)
    {
        if (list.Count == 0 || IsCoveredByOne(list) || Math.Max(tile.Width, tile.Height) <= PartSide) CastPart(tile, list);
        else
            for (var row = 0; row < tile.Height; row += PartsUp * PartSide)
            {
                parts.Cut(tile with { Row = tile.Row + row, Height = Math.Min(PartsUp * PartSide, tile.Height - row) }, PartSide, PartsAcross);
                Narrow(parts, list, ofParts);
                for (var i = 0; i < RegionPacket.Count; i++)
                {
                    if (parts[i].Area == 0) continue;
                    if (MergeUniform(parts, ofParts, i) is > 0 and var count) i += count - 1;
                    else CastPart(parts[i], ofParts[i]);
                }
            }
    }

    private void CastPart(in PixelRect part, List<Candidate> list)
    {
        if (list.Count == 0 && !hasSeveralMeshes) consumer.FillBackground(part);
        else CastRows(part, list);
    }

    private void Narrow(RegionPacket parts, List<Candidate> whole, List<Candidate>[] lists)
    {
        Span<double> farthestTs = stackalloc double[RegionPacket.Count];
        farthestTs.Fill(double.PositiveInfinity);
        foreach (var list in lists) list.Clear();
        foreach (var candidate in whole)
        {
            ref var showsIn = ref showIn[candidate.Index];
            var ranges = context.Plan.UsesIntervals ? views[candidate.Index].Narrow(parts, candidate.Range) : new(candidate.Range);
            for (var i = 0; i < RegionPacket.Count; i++)
            {
                if (!showsIn.Overlaps(parts[i])) continue;
                var range = ranges[i];
                farthestTs[i] = Math.Min(farthestTs[i], range.FarthestT);
                lists[i].Add(candidate with { Range = range });
            }
        }
        for (var i = 0; i < RegionPacket.Count; i++) DropHidden(lists[i], farthestTs[i]);
    }

    private bool IsCoveredByOne(List<Candidate> list) =>
        list.Count == 1 && list[0].Range.FarthestT < double.PositiveInfinity && isShape(list[0]);

    /// <summary>Whether a kernel for its only shape paints the part.</summary>
    private bool HasKernel(List<Candidate> list) => context.Plan.UsesShapeKernels && IsCoveredByOne(list);

    /// <summary>Casts neighbouring parts at once if they are all empty or all covered by the same model: long rows are written faster than short
    /// ones.</summary>
    /// <returns>How many parts are done, from the first on.</returns>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private int MergeUniform(RegionPacket parts, List<Candidate>[] lists, int first)
    {
        if (hasSeveralMeshes) return 0;
        var isBackground = lists[first].Count == 0;
        if (!isBackground && !HasKernel(lists[first])) return 0;
        var only = isBackground ? default : lists[first][0];
        var whole = parts[first];
        var end = first + 1;
        for (; end % parts.Across != 0; end++)
        {
            var list = lists[end];
            if (isBackground ? list.Count > 0 : !HasKernel(list) || list[0].Index != only.Index) break;
            whole = whole with { Width = whole.Width + parts[end].Width };
            if (!isBackground && !list[0].Range.IsFirstCrossing) only = list[0];
        }
        if (isBackground) consumer.FillBackground(whole);
        else if (!consumer.PaintCovered(new(whole, views[only.Index], modelIndices[only.Index], only.Range.IsFirstCrossing))) return 0;
        return end - first;
    }

    /// <summary>Drops models that do not show or lie behind one that covers the part.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void DropHidden(List<Candidate> list, double farthestT)
    {
        var kept = 0;
        for (var i = 0; i < list.Count; i++)
            if (list[i].Range.NearestT <= farthestT && list[i].Range.NearestT < double.PositiveInfinity)
                list[kept++] = list[i];
        list.RemoveRange(kept, list.Count - kept);
    }

    /// <summary>Casts the rays of a part: row by row, or all rows at once in a small part whose models are all single shapes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void CastRows(in PixelRect part, List<Candidate> list)
    {
        var isSmall = part.Area <= RayStream.MaxArea && part.Width % N.Count == 0 && list.TrueForAll(isShape);
        var rows = isSmall ? part.Height : 1;
        rays.Begin<N>(part.Column, part.Width);
        for (var row = part.Row; row < part.EndRow; row += rows)
        {
            rays.Aim<N>(row, rows);
            if (hasSeveralMeshes) rays.CopyHits<N>(ofMeshes!);
            foreach (var candidate in list) views[candidate.Index].Intersect(rays, modelIndices[candidate.Index]);
            consumer.Consume(rays);
        }
    }
}

/// <summary>A model that may show in a tile.</summary>
internal readonly record struct Candidate(int Index, HitRange Range);
