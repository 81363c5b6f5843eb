using System.Buffers.Text;

namespace RayCaster.Files;

internal enum PlyRole { X, Y, Z, Corners, Strips, Skipped }

internal enum PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 }

/// <summary>One value of each row of an element; a list if it has a type for its count.</summary>
internal readonly record struct PlyProperty(PlyRole Role, PlyType Type, PlyType? CountType)
{
    public static ReadOnlySpan<byte> Sizes => [1, 1, 2, 2, 4, 4, 4, 8]; // by type

    public int Size => Sizes[(int)Type];
}

/// <param name="Name">What its rows are: <c>vertex</c>, <c>face</c>, <c>tristrips</c>, or anything else, which is skipped.</param>
internal sealed record PlyElement(string Name, long Count, int Line)
{
    public List<PlyProperty> Properties { get; } = [];
}

/// <summary>The lines from <c>ply</c> to <c>end_header</c>.</summary>
internal sealed class PlyHeader
{
    public const int MaxBytes = 1 << 20;

    private readonly MeshSource source;

    private static readonly (string Old, string New)[] typeNames =
    [
        ("char", "int8"), ("uchar", "uint8"), ("short", "int16"), ("ushort", "uint16"),
        ("int", "int32"), ("uint", "uint32"), ("float", "float32"), ("double", "float64"),
    ];

    public PlyHeader(MeshSource source)
    {
        (this.source, Scanner) = (source, new(source));
        if (NextWord() != "ply") throw Scanner.Error("a PLY file must begin with the line 'ply'");
        var endsWithCr = Scanner.LineEnd is [(byte)'\r'];
        ReadLines();
        // If lines end with a lone CR, a byte 10 after the last one is not its LF but the first byte of the data.
        if (Format == "ascii") Scanner.NextLine();
        else Scanner.EndText(endsWithCr ? 1 : Scanner.LineEnd.Length);

        VertexCount = Require("vertex", (PlyRole.X, "x"), (PlyRole.Y, "y"), (PlyRole.Z, "z")).Count;
        if (!Elements.Exists(element => element.Properties.Exists(property => property.Role == PlyRole.Strips)))
            Require("face", (PlyRole.Corners, "list vertex_indices"));
    }

    /// <summary>At the first row of an ascii file.</summary>
    public TextScanner Scanner { get; }

    /// <summary><c>ascii</c>, <c>binary_little_endian</c> or <c>binary_big_endian</c>.</summary>
    public string Format { get; private set; } = "";

    public List<PlyElement> Elements { get; } = [];

    public long VertexCount { get; }

    private void ReadLines()
    {
        while (source.Position < MaxBytes && Scanner.NextLine())
        {
            switch (NextWord())
            {
                case "format": ReadFormat(); break;
                case "element": ReadElement(); break;
                case "property": ReadProperty(); break;
                case "comment" or "obj_info" or "": break;
                case "end_header" when Format == "": throw Scanner.Error("the header has no format");
                case "end_header": return;
                default:
                    throw Scanner.Error(
                        $"a header line must be format, element, property, comment, obj_info or end_header, but is {Scanner.Quoted}");
            }
        }
        throw Scanner.Error(source.Length > MaxBytes
            ? $"end_header is missing in the first {MaxBytes} bytes; a header must not be longer"
            : "the file ends within the header: end_header is missing");
    }

    private void ReadFormat()
    {
        Format = NextWord();
        if (Format is not ("ascii" or "binary_little_endian" or "binary_big_endian"))
            throw Scanner.Error($"the format must be ascii, binary_little_endian or binary_big_endian, but is {Scanner.Quoted}");
        if (NextWord() != "1.0") throw Scanner.Error($"the version of the format must be 1.0, but is {Scanner.Quoted}");
    }

    private void ReadElement()
    {
        var name = NextWord();
        var line = Scanner.LineNumber;
        if (name is "vertex" or "face" or "tristrips" && Elements.Exists(element => element.Name == name))
            throw Scanner.Error($"the element {name} is there twice");
        var word = Scanner.NextInLine();
        if (!Utf8Parser.TryParse(word, out long count, out var length) || length < word.Length || count < 0)
            throw Scanner.Error($"the count of an element must be a whole number from 0 on, but is {Scanner.Quoted}");
        Elements.Add(new(name, count, line));
    }

    private void ReadProperty()
    {
        if (Elements.Count == 0) throw Scanner.Error("a property must come after its element");
        var element = Elements[^1];
        var type = NextWord();
        PlyType? countType = type == "list" ? ToType(NextWord()) : null;
        if (countType is PlyType.Float32 or PlyType.Float64) throw Scanner.Error("the count of a list must be of a whole-number type");
        var valueType = ToType(countType is null ? type : NextWord());
        var role = (element.Name, NextWord(), countType is not null) switch
        {
            ("vertex", "x", false) => PlyRole.X,
            ("vertex", "y", false) => PlyRole.Y,
            ("vertex", "z", false) => PlyRole.Z,
            ("face", "vertex_indices" or "vertex_index", true) => PlyRole.Corners,
            ("tristrips", "vertex_indices" or "vertex_index", true) => PlyRole.Strips,
            _ => PlyRole.Skipped,
        };
        if (role != PlyRole.Skipped && element.Properties.Exists(property => property.Role == role))
            throw Scanner.Error("the element has this property twice");
        element.Properties.Add(new(role, valueType, countType));
    }

    private PlyType ToType(string name)
    {
        var type = Array.FindIndex(typeNames, names => names.Old == name || names.New == name);
        return type >= 0 ? (PlyType)type
            : throw Scanner.Error($"{Scanner.Quoted} is no type; types are char, uchar, short, ushort, int, uint, float, double, int8 … float64");
    }

    private PlyElement Require(string name, params ReadOnlySpan<(PlyRole Role, string Name)> needed)
    {
        var element = Elements.Find(element => element.Name == name) ?? throw source.Error($"the file has no element {name}"
            + (VertexCount > 0 ? $", only {Digits.Count(VertexCount, "vertex")}; a mesh needs at least one face" : ""));
        foreach (var (role, property) in needed)
            if (!element.Properties.Exists(p => p.Role == role))
                throw source.ErrorAtLine(element.Line, $"the element {name} must have the property {property}");
        return element;
    }

    private string NextWord() => Encoding.UTF8.GetString(Scanner.NextInLine());
}
