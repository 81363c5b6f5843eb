using System.Buffers.Text;

namespace RayCaster.Files;

/// <summary>Wavefront OBJ: the statements <c>v x y z</c> and <c>f i j k …</c>; all others are skipped, those that are not known with a
/// warning.</summary>
internal static class ObjFile
{
    public static MeshData Read(MeshSource source)
    {
        source.ThrowUnless("an OBJ mesh");
        source.Has(64);
        var start = source.Bytes[..Math.Min(source.Bytes.Length, 64)];
        if (start.IndexOfAny("\0\r\n"u8) is >= 0 and var at && start[at] == 0)
            throw source.Error("it is no text, and so no OBJ mesh; compiled files have the same extension");
        var scanner = new TextScanner(source, isObj: true);
        var mesh = new MeshBuilder(source);
        var lines = 0;
        var points = 0;
        var ahead = new List<(long Index, int Line)>(); // of faces before their vertices: each index that is greater than those before it
        var skipped = new SkippedStatements();
        string? warning = null;
        do
        {
            switch (scanner.NextInLine())
            {
                case [(byte)'v']: mesh.BeginBlock(); ReadVertex(scanner, mesh); break;
                case [(byte)'f']: ReadFace(scanner, mesh, ahead); break;
                case [(byte)'l']: lines++; break;
                case [(byte)'p']: points++; break;
                case var statement when statement.SequenceEqual("usemtl"u8) || statement.SequenceEqual("mtllib"u8):
                    warning = "the file's materials are ignored; \"color\" colours the whole mesh";
                    break;
                case []: break;
                case [(byte)'v', (byte)'t' or (byte)'n']: break;
                case [(byte)'g' or (byte)'o' or (byte)'s']: break;
                case var statement: skipped.Add(statement, scanner); break;
            }
        }
        while (scanner.NextLine());

        foreach (var (index, line) in ahead)
            if (index > mesh.VertexCount)
                throw source.ErrorAtLine(line, $"face index {index} is beyond the file's {mesh.VertexCount} vertices");
        var warnings = string.Join("; ", ((string?[])[warning, skipped.Warning, lines + points > 0 ? null : mesh.UnusedBlocks()]).OfType<string>());
        return mesh.Finish(warnings.Length > 0 ? warnings : null, others: [(lines, "line"), (points, "point")]);
    }

    private static void ReadVertex(TextScanner scanner, MeshBuilder mesh)
    {
        mesh.AddVertex(new(scanner.NextNumber("the vertex's x"), scanner.NextNumber("the vertex's y"), scanner.NextNumber("the vertex's z")));
        while (scanner.NextInLine() is { IsEmpty: false } more) // weights and colours, which may be no numbers
            if (!TextScanner.IsNumber(more, out _) && !IsNotFinite(more)) scanner.ToNumber(more, "what follows a vertex's x, y and z");
    }

    private static void ReadFace(TextScanner scanner, MeshBuilder mesh, List<(long Index, int Line)> ahead)
    {
        mesh.BeginFace();
        while (scanner.NextInLine() is { IsEmpty: false } corner)
        {
            var index = ToIndex(corner, scanner);
            if (index < -mesh.VertexCount)
                throw scanner.Error($"face index {index} counts back beyond the {mesh.VertexCount} vertices that are above it");
            if (index > mesh.VertexCount && (ahead.Count == 0 || index > ahead[^1].Index)) ahead.Add((index, scanner.LineNumber));
            mesh.AddCorner((int)Math.Min(index < 0 ? mesh.VertexCount + index : index - 1, int.MaxValue));
        }
        mesh.EndFace("a face", "corners", scanner.LineNumber, scanner.Error);
    }

    /// <summary>Whether a program has written NaN or infinity: <c>nan</c>, <c>-nan(ind)</c>, <c>Infinity</c>, <c>1.#QNAN</c>.</summary>
    private static bool IsNotFinite(ReadOnlySpan<byte> word)
    {
        var letters = word.TrimStart("+-"u8);
        if (letters.StartsWith("1.#"u8)) return true;
        return letters.Length >= 3 && (Ascii.EqualsIgnoreCase(letters[..3], "nan") || Ascii.EqualsIgnoreCase(letters[..3], "inf"));
    }

    /// <summary>The vertex of a corner: <c>7</c>, <c>7/1</c>, <c>7/1/3</c> or <c>7//3</c> (vertex, texture, normal); numbers may be left out at
    /// the end, as in <c>7//</c>.</summary>
    private static long ToIndex(ReadOnlySpan<byte> corner, TextScanner scanner)
    {
        var isCorner = Utf8Parser.TryParse(corner, out long index, out var length);
        var rest = corner[length..];
        for (var part = 0; isCorner && part < 2 && rest is [(byte)'/', ..]; part++)
        {
            Utf8Parser.TryParse(rest[1..], out long _, out length); // of length 0 where nothing is written
            rest = rest[(1 + length)..];
        }
        if (!isCorner || !rest.IsEmpty) throw scanner.Error($"a face's corner must be like 7, 7/1, 7/1/3 or 7//3, but is {scanner.Quoted}"
            + NumberSpelling.SeparatorHint(Encoding.UTF8.GetString(corner)));
        if (index == 0) throw scanner.Error("face index 0 is not allowed: vertices count from 1, or from -1 backwards");
        return index;
    }
}
