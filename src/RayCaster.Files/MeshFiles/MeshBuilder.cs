namespace RayCaster.Files;

/// <summary>Collects the vertices and faces of a block; splits polygons into fans.</summary>
/// <param name="isInOrder">Whether one builder collects all blocks of the file in order, so that it can count the vertices above.</param>
internal sealed class MeshBuilder(MeshSource source, bool isInOrder)
{
    private readonly List<Vector3> vertices = [];
    private readonly List<int> indices = [];
    private int first, previous;
    private long verticesBefore;

    /// <summary>How many vertices the file has up to here; null where that is not known yet.</summary>
    public long? VerticesAbove => isInOrder ? verticesBefore + vertices.Count : null;

    public int CornerCount { get; private set; }

    public void AddVertex(Vector3 vertex) => vertices.Add(vertex);

    public void BeginFace() => CornerCount = 0;

    /// <summary>Makes room for all triangles of one face at once: doubling the room step by step would take twice the memory.</summary>
    public void Expect(long triangles)
    {
        if (triangles > 1) indices.EnsureCapacity((int)Math.Min(indices.Count + 3 * triangles, Array.MaxLength));
    }

    /// <summary>Adds a corner to the face. Each corner from the third on makes a triangle with the first corner and the one before.</summary>
    /// <param name="vertex">The place among the file's vertices, from 0. A place beyond every array becomes the last int, which is one too.</param>
    public void AddCorner(long vertex) => Add((int)Math.Min(vertex, int.MaxValue));

    /// <summary>Adds a corner to the face; −1 is the vertex that was added last.</summary>
    public void AddCornerBack(long back)
    {
        var place = MeshPiece.Here + vertices.Count + back;
        if (place < int.MinValue) throw source.Error("a face counts back too far to be kept until the vertices above are counted");
        Add((int)place);
    }

    /// <summary>What was collected since the last piece.</summary>
    public MeshPiece TakePiece()
    {
        var piece = new MeshPiece([.. vertices], [.. indices]);
        verticesBefore += vertices.Count;
        vertices.Clear();
        indices.Clear();
        return piece;
    }

    private void Add(int corner)
    {
        if (CornerCount == 0) first = corner;
        if (CornerCount >= 2)
        {
            indices.Add(first);
            indices.Add(previous);
            indices.Add(corner);
        }
        previous = corner;
        CornerCount++;
    }
}
