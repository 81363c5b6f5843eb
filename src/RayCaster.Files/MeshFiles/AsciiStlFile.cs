namespace RayCaster.Files;

/// <summary>Ascii STL. Line ends separate words like blanks do, but the name of a solid ends with its line.</summary>
internal sealed class AsciiStlFile(MeshSource source) : MeshFormat(source)
{
    /// <summary>Blocks are cut after a facet, so each block but the first begins within a solid.</summary>
    public override void Read(MeshBlock block, MeshBuilder mesh)
    {
        var scanner = new TextScanner(block);
        var word = scanner.Next();
        var isInSolid = block.Start > 0;
        if (!isInSolid && !Is(word, "solid"))
            throw scanner.Error($"an ascii STL file must begin with 'solid', but this one begins with {scanner.Quoted}");
        for (; isInSolid || !word.IsEmpty; isInSolid = false)
        {
            if (!isInSolid)
            {
                if (!Is(word, "solid")) throw Expected("solid");
                word = NextAfterName();
            }
            for (; Is(word, "facet"); word = scanner.Next()) ReadFacet();
            if (word.IsEmpty && !block.IsLast) return;
            if (!Is(word, "endsolid")) throw Expected("facet' or 'endsolid");
            word = scanner.NextLine() ? scanner.Next() : []; // the name may stand here again
        }

        void ReadFacet()
        {
            Expect("normal");
            for (var i = 0; i < 3; i++) scanner.Next(); // the normal is not needed; for slivers some programs write nan
            Expect("outer");
            Expect("loop");
            mesh.BeginFace();
            var word = scanner.Next();
            for (; Is(word, "vertex"); word = scanner.Next())
            {
                var (x, y, z) = (Number("the vertex's x"), Number("the vertex's y"), Number("the vertex's z"));
                mesh.AddVertex(new(x, y, z));
                mesh.AddCornerBack(-1);
            }
            if (!Is(word, "endloop")) throw Expected("vertex' or 'endloop");
            if (mesh.CornerCount < 3) throw scanner.Error($"a facet needs at least three vertices, but this one has {mesh.CornerCount}");
            Expect("endfacet");
        }

        // The number may stand on a later line. If it is missing there too, the error belongs to this line.
        double Number(string what)
        {
            var word = scanner.NextInLine();
            if (!word.IsEmpty) return scanner.ToNumber(word, what);
            var lineEnd = scanner.WordAt;
            return TextScanner.TryParse(scanner.Next(), out var number) ? number : throw scanner.ErrorAt(lineEnd, $"{what} is missing");
        }

        // A solid's name is the rest of its line, unless the whole solid is written in one line.
        ReadOnlySpan<byte> NextAfterName()
        {
            while (scanner.NextInLine() is { IsEmpty: false } word)
            {
                var afterWord = scanner.Position;
                if (Is(word, "facet") && Is(scanner.NextInLine(), "normal"))
                {
                    scanner.Position = afterWord;
                    return word;
                }
                scanner.Position = afterWord;
            }
            return scanner.Next();
        }

        void Expect(string keyword)
        {
            if (!Is(scanner.Next(), keyword)) throw Expected(keyword);
        }

        MeshFileException Expected(string keyword) => scanner.Error($"expected '{keyword}', found {scanner.Quoted}");
    }

    /// <summary>
    /// After the last line of a facet: a line of a vertex, then endloop, then endfacet. A name is one line, and a normal three words, so no name
    /// or normal can contain these three lines by chance.
    /// </summary>
    public override int Cut(ReadOnlySpan<byte> text, bool isEnd)
    {
        if (isEnd) return text.Length;
        var (cut, linesFound) = (0, 0);
        for (var left = text; TextScanner.TryTakeLastLine(ref left, out var line);)
        {
            var words = line.Trim(" \t\v\f"u8);
            if (words.IsEmpty) continue;
            if (linesFound == 2 && words.Length > 7 && Is(words[..6], "vertex") && words[6] is (byte)' ' or (byte)'\t') return cut;
            if (linesFound == 1 && Is(words, "endloop"))
                linesFound = 2;
            else if (Is(words, "endfacet"))
                (cut, linesFound) = (left.Length + 1, 1);
            else
                linesFound = 0;
        }
        return 0;
    }

    private static bool Is(ReadOnlySpan<byte> word, string keyword) => Ascii.EqualsIgnoreCase(word, keyword);
}
