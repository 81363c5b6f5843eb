namespace RayCaster.Files;

/// <summary>Ascii STL. Line ends separate words like blanks do, but the name of a solid ends with its line.</summary>
internal sealed class AsciiStlFile
{
    private readonly TextScanner scanner;
    private readonly MeshBuilder mesh;
    private int? skippedIn; // the first line with words that were skipped

    private AsciiStlFile(MeshSource source) => (scanner, mesh) = (new(source), new(source));

    public static MeshData Read(MeshSource source) => new AsciiStlFile(source).Read();

    private MeshData Read()
    {
        var word = scanner.Next();
        if (!Is(word, "solid"))
            throw scanner.Error($"an ascii STL file must begin with 'solid', but this one begins with {scanner.Quoted}");
        while (!word.IsEmpty)
        {
            if (!Is(word, "solid")) throw Expected("solid");
            for (word = NextAfterName(); Is(word, "facet"); word = NextKeyword()) ReadFacet();
            if (!Is(word, "endsolid")) throw Expected("facet' or 'endsolid");
            word = scanner.NextLine() ? scanner.Next() : []; // the name may stand here again
        }
        return mesh.Finish(skippedIn is { } line ? $"text after endloop or endfacet is ignored, first in line {line} of the file" : null);
    }

    private void ReadFacet()
    {
        Expect("normal", scanner.Next());
        for (var i = 0; i < 3; i++) scanner.Next(); // the normal is not needed; for slivers some programs write nan
        Expect("outer", scanner.Next());
        Expect("loop", scanner.Next());
        mesh.BeginFace();
        var word = scanner.Next();
        for (; Is(word, "vertex"); word = scanner.Next())
        {
            mesh.AddVertex(new(Number("the vertex's x"), Number("the vertex's y"), Number("the vertex's z")));
            mesh.AddCorner(mesh.VertexCount - 1);
        }
        if (!Is(Joined(word), "endloop")) throw Expected("vertex' or 'endloop");
        mesh.EndFace("a facet", "vertices", scanner.LineNumber, scanner.Error);
        Expect("endfacet", NextKeyword());
    }

    // The number may stand on a later line. If it is missing there too, the error belongs to this line.
    private double Number(string what)
    {
        var word = scanner.NextInLine();
        if (!word.IsEmpty) return scanner.ToNumber(word, what);
        var missing = scanner.Error($"{what} is missing");
        return TextScanner.TryParse(scanner.Next(), out var number) ? number : throw missing;
    }

    // A solid's name is the rest of its line, unless the whole solid is written in one line.
    private ReadOnlySpan<byte> NextAfterName()
    {
        while (scanner.NextInLine() is { IsEmpty: false } word)
        {
            var afterWord = scanner.Position;
            var isFacet = Is(word, "facet") && Is(scanner.NextInLine(), "normal");
            scanner.Return(afterWord);
            if (isFacet) return word;
        }
        return scanner.Next();
    }

    /// <summary>The word after endloop or endfacet. Some programs write a text behind these; it is skipped, as in other readers.</summary>
    private ReadOnlySpan<byte> NextKeyword()
    {
        while (scanner.NextInLine() is { IsEmpty: false } word)
        {
            word = Joined(word);
            if (Is(word, "facet") || Is(word, "endfacet") || Is(word, "endsolid")) return word;
            skippedIn ??= scanner.LineNumber;
        }
        return Joined(scanner.Next());
    }

    /// <summary>Some programs write <c>end loop</c>, <c>end facet</c> and <c>end solid</c>.</summary>
    private ReadOnlySpan<byte> Joined(ReadOnlySpan<byte> word)
    {
        if (!Is(word, "end")) return word;
        var position = scanner.Position;
        var second = scanner.NextInLine();
        if (Is(second, "loop")) return "endloop"u8;
        if (Is(second, "facet")) return "endfacet"u8;
        if (Is(second, "solid")) return "endsolid"u8;
        scanner.Return(position);
        return word;
    }

    private void Expect(string keyword, ReadOnlySpan<byte> word)
    {
        if (!Is(word, keyword)) throw Expected(keyword);
    }

    private ProblemException Expected(string keyword) => scanner.Error($"expected '{keyword}', found {scanner.Quoted}");

    private static bool Is(ReadOnlySpan<byte> word, string keyword) => Ascii.EqualsIgnoreCase(word, keyword);
}
