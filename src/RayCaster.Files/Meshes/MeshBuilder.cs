using System.Runtime.InteropServices;

namespace RayCaster.Files;

/// <summary>Collects the vertices and faces of a mesh file; splits polygons into fans.</summary>
internal sealed class MeshBuilder(MeshSource source)
{
    /// <summary>The most triangles of a mesh: their indices are one array.</summary>
    public static int MaxTriangles => Array.MaxLength / 3;

    private readonly List<Vector3> vertices = [];
    private readonly List<int> indices = [];
    private readonly List<(int Index, int Count, long Place)> early = []; // polygons before their vertices
    private readonly List<(int Vertices, int Indices)> blocks = []; // where vertices follow faces, another object begins
    private int first, previous, greatest, folded, facesBefore;
    private long foldedAt;

    public int VertexCount => vertices.Count;

    public int CornerCount { get; private set; }

    public void AddVertex(Vector3 vertex) => vertices.Add(vertex);

    public void BeginBlock()
    {
        if (indices.Count > facesBefore) blocks.Add((vertices.Count, indices.Count));
        facesBefore = indices.Count;
    }

    /// <summary>A warning if the faces of an object begin at the file's first vertex, while it has unused vertices of its own and as many as they
    /// need; otherwise null.</summary>
    public string? UnusedBlocks()
    {
        if (blocks.Count == 0) return null;
        var isUsed = new bool[vertices.Count];
        foreach (var index in indices) isUsed[index] = true;
        blocks.Add((vertices.Count, indices.Count));
        for (var i = 1; i < blocks.Count; i++)
        {
            var own = isUsed.AsSpan(blocks[i - 1].Vertices..blocks[i].Vertices);
            var faces = CollectionsMarshal.AsSpan(indices)[blocks[i - 1].Indices..blocks[i].Indices];
            if (own.Contains(false) && faces.Contains(0) && !faces.ContainsAnyExceptInRange(0, own.Length - 1))
                return $"{isUsed.Count(used => !used)} of {vertices.Count} vertices belong to no face: do the indices of each object begin at 1? " +
                    "They count on through the file";
        }
        return null;
    }

    public void BeginFace() => CornerCount = greatest = 0;

    /// <summary>Adds a corner to the face. Each corner from the third on makes a triangle with the first corner and the one before.</summary>
    public void AddCorner(int vertex)
    {
        if (CornerCount == 0) first = vertex;
        if (CornerCount >= 2) AddTriangle(first, previous, vertex);
        previous = vertex;
        greatest = Math.Max(greatest, vertex);
        CornerCount++;
    }

    /// <summary>Ends a face of three corners or more, and notes whether it is another shape than its fan.</summary>
    /// <param name="place">The line or byte where it is.</param>
    public void EndFace(string what, string corners, long place, Func<string, ProblemException> error)
    {
        if (CornerCount < 3) throw error($"{what} needs at least three {corners}, but this one has {CornerCount}");
        if (CornerCount <= 3) return;
        var count = 3 * (CornerCount - 2);
        if (greatest < vertices.Count) Check(indices.Count - count, count, place);
        else early.Add((indices.Count - count, count, place));
    }

    public void AddTriangle(int a, int b, int c)
    {
        if (indices.Count >= 3 * MaxTriangles)
            throw source.Error($"the file has too many faces; at most {MaxTriangles} triangles are read");
        indices.Add(a);
        indices.Add(b);
        indices.Add(c);
    }

    /// <param name="placeName">What <see cref="EndFace"/> was told: "in line" or "at byte".</param>
    /// <param name="others">What the file has besides vertices and faces.</param>
    public MeshData Finish(string? warning = null, string placeName = "in line", params (int Count, string Name)[] others)
    {
        if (indices.Count == 0)
        {
            string[] has = [.. from other in others.Prepend((Count: vertices.Count, Name: "vertex")) where other.Count > 0
                               select Digits.Count(other.Count, other.Name)];
            throw source.Error($"the file has no face{(has.Length > 0 ? $", only {string.Join(" and ", has)}" : "")}; a mesh needs at least one"
                + (warning is null ? "" : "; " + warning));
        }
        foreach (var (index, count, place) in early) Check(index, count, place);
        if (folded > 0)
        {
            warning = (warning is null ? "" : warning + "; ") + $"the face {placeName} {foldedAt} {Fan.Warning}"
                + (folded > 1 ? $", as {Digits.Count(folded - 1, "other face")}" : "");
        }
        return new([.. vertices], [.. indices]) { Warning = warning };
    }

    private void Check(int index, int count, long place)
    {
        if (!Fan.IsFolded(CollectionsMarshal.AsSpan(indices).Slice(index, count), CollectionsMarshal.AsSpan(vertices))) return;
        if (folded++ == 0) foldedAt = place;
    }
}
