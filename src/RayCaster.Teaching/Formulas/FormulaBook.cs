namespace RayCaster.Teaching.Formulas;

/// <summary>The slides' formulas, read from the texts beside this file: each step in each right style.</summary>
internal sealed class FormulaBook
{
    private static readonly Lazy<FormulaBook> slides = new(() => new(
        from file in (string[])["Vectors.txt", "Camera.txt", "Shapes.txt", "Hits.txt"]
        select (file, TextOf(file))));

    private readonly Dictionary<StepKind, List<Step>> steps = [];
    private readonly Dictionary<StepKind, Dictionary<string, Expression>> givens = [];
    private readonly Dictionary<StepKind, string> symptoms = [];
    private readonly Dictionary<string, string> words = []; // of names that stand on no slide

    /// <param name="texts">The texts, each with the name that an error shows.</param>
    /// <exception cref="FormatException">What is wrong, and where.</exception>
    public FormulaBook(IEnumerable<(string File, string Text)> texts)
    {
        foreach (var (file, text) in texts) new Reader(this, file).Read(text);
    }

    /// <summary>The formulas of the slides.</summary>
    public static FormulaBook Slides => slides.Value;

    /// <summary>What every scene gives.</summary>
    private static Dictionary<string, Expression> OfScene { get; } = Names(
        "P: point, T: point, up: direction, fovY: angle, width: pixels, height: pixels, byDepth: truth, zNear: length, zFar: length, bias: length, "
        + "∞: length, π: none");

    /// <summary>The pixel: x from the left, y from the top. The camera is made before there is one.</summary>
    private static Dictionary<string, Expression> OfPixel { get; } = Names("x: pixels, y: pixels");

    /// <summary>The styles of a step, the slides' own first.</summary>
    public IReadOnlyList<Step> StylesOf(StepKind kind) => steps[kind];

    public Step this[StepKind kind, string style] => steps[kind].First(step => step.Style == style);

    /// <summary>Whether a step is given a name, such as a sphere its R.</summary>
    public bool IsGiven(StepKind kind, Symbol name) => givens.TryGetValue(kind, out var own) && own.ContainsKey(name.Text);

    /// <summary>The names that a step is given, in the order of the text.</summary>
    public IEnumerable<Symbol> GivenTo(StepKind kind) => givens[kind].Keys.Select(Symbol.From);

    /// <summary>What one sees if the formulas of a step are wrong.</summary>
    public string SymptomOf(StepKind kind) => symptoms.GetValueOrDefault(kind)
        ?? $"Only {ShapeKind.Find(kind).Many} are wrong; everything else is right.";

    /// <summary>What a name means; itself where it stands on the slide.</summary>
    public string InWords(string name) => words.GetValueOrDefault(name, name);

    /// <summary>A text that lies beside this file.</summary>
    public static string TextOf(string file)
    {
        using var stream = typeof(FormulaBook).Assembly.GetManifestResourceStream(file)!;
        return new StreamReader(stream, Encoding.UTF8).ReadToEnd();
    }

    private static Dictionary<string, Expression> Names(string list)
    {
        var names = new Dictionary<string, Expression>();
        foreach (var item in list.Split(','))
        {
            if (item.Split(':', StringSplitOptions.TrimEntries) is not [var name, var unit])
                throw new FormatException($"'{item.Trim()}' where a name and its unit are expected, as in 'R: length'");
            names.Add(name, Expression.Name(Symbol.From(name), UnitOf(unit)));
        }
        return names;
    }

    private static Dimension UnitOf(string word) => Dimension.Words.TryGetValue(word, out var unit) ? unit
        : throw new FormatException($"unknown unit '{word}'; there are {string.Join(", ", Dimension.Words.Keys)}");

    /// <summary>What a step computes for later steps; its other names are its own.</summary>
    private static readonly string[] results = ["W", "U", "V", "h", "w", "column", "row", "c", "r", "d"];

    /// <summary>The names that a step can read besides what it is given: what earlier steps have computed.</summary>
    private Dictionary<string, Expression> ScopeOf(StepKind kind)
    {
        StepKind[] before = kind switch
        {
            StepKind.Vectors or StepKind.Camera or StepKind.File or StepKind.Bytes => [],
            StepKind.Corner or StepKind.Center => [StepKind.File],
            StepKind.Pixel => [StepKind.Camera, StepKind.Corner],
            _ => [StepKind.Camera, StepKind.Pixel],
        };
        var scope = new Dictionary<string, Expression>();
        if (kind is not (StepKind.Vectors or StepKind.Bytes))
        {
            var isOfPixel = kind is StepKind.File or StepKind.Pixel;
            foreach (var (name, expression) in isOfPixel ? OfScene.Concat(OfPixel) : OfScene) scope[name] = expression;
        }
        foreach (var formula in before.SelectMany(step => steps[step][0].Formulas).Where(formula => results.Contains(formula.Name.Text)))
            scope[formula.Name.Text] = Expression.Name(formula.Name, formula.Right.Dimension);
        if (givens.TryGetValue(kind, out var own))
            foreach (var (name, expression) in own) scope[name] = expression;
        return scope;
    }

    /// <summary>Reads a text line by line.</summary>
    private sealed class Reader(FormulaBook book, string file)
    {
        private readonly List<Formula> formulas = [];
        private StepKind? kind;
        private string style = "", slide = "";
        private Dictionary<string, Expression> scope = [], start = [];

        public void Read(string text)
        {
            var number = 0;
            foreach (var line in text.Split('\n').Select(line => line.Trim()))
            {
                number++;
                try
                {
                    if (line.Length > 0 && line[0] != '#') ReadLine(line);
                }
                catch (FormatException error)
                {
                    throw new FormatException($"{file}({number}): [{kind?.ToString().ToLowerInvariant()}] {style}: {error.Message}", error);
                }
            }
            End();
        }

        private void ReadLine(string line)
        {
            if (line[0] == '[') Begin(line);
            else if (line.Split(' ', 3) is ["word", var name, var meaning]) book.words.TryAdd(name, meaning);
            else if (kind is not { } own) throw new FormatException("a formula before the first [step]");
            else if (line.StartsWith("slide ", StringComparison.Ordinal)) slide = line[6..].Trim('"');
            else if (line.StartsWith("symptom ", StringComparison.Ordinal)) book.symptoms.Add(own, line[8..]);
            else if (line.StartsWith("given ", StringComparison.Ordinal))
            {
                book.givens[own] = Names(line[6..]);
                start = book.ScopeOf(own);
                scope = new(start);
            }
            else if (line.StartsWith("hits ", StringComparison.Ordinal)) ReadHits(line[5..]);
            else ReadFormula(line);
        }

        private void Begin(string line)
        {
            End();
            var end = line.IndexOf(']', StringComparison.Ordinal);
            if (end < 0 || !Enum.TryParse<StepKind>(line[1..end], ignoreCase: true, out var found))
                throw new FormatException(
                    $"'{line}' where a step is expected: {string.Join(", ", Enum.GetNames<StepKind>()).ToLowerInvariant()}");
            (kind, style) = (found, line[(end + 1)..].Trim());
            start = book.ScopeOf(found);
            scope = new(start);
        }

        private void End()
        {
            if (kind is not { } own) return;
            if (!book.steps.TryGetValue(own, out var styles)) book.steps[own] = styles = [];
            styles.Add(new(own, style, slide, start, [.. formulas]));
            formulas.Clear();
        }

        private void ReadHits(string line)
        {
            var parts = line.Split(" when ");
            var crossings = parts[0].Split(", ");
            if (crossings.Length > 2) throw new FormatException("more than two crossings");
            Add(Formula.Near, Parse(crossings[0]));
            if (crossings.Length > 1) Add(Formula.Far, Parse(crossings[1]));
            if (parts.Length > 1) Add(Formula.When, Parse(parts[1]));
        }

        /// <summary>name: unit = expression, or name(a, b): unit = expression.</summary>
        private void ReadFormula(string line)
        {
            var parts = line.Split('=', 2, StringSplitOptions.TrimEntries);
            var head = parts[0].Split(':', StringSplitOptions.TrimEntries);
            if (parts.Length < 2 || head.Length != 2) throw new FormatException($"'{line}' where 'name: unit = expression' is expected");
            var claimed = UnitOf(head[1]);
            if (head[0].TrimEnd(')').Split('(') is [var function, var list])
            {
                Symbol[] parameters = [.. list.Split(", ").Select(Symbol.Parameter)];
                var own = parameters.ToDictionary(parameter => parameter.Text, Expression.Parameter);
                formulas.Add(new(Symbol.From(function), Claimed(new ExpressionParser(parts[1], own).Parse(), claimed), [.. parameters]));
            }
            else Add(Symbol.From(head[0]), Claimed(Parse(parts[1]), claimed));
        }

        private Expression Parse(string text) => new ExpressionParser(text, scope).Parse();

        private void Add(Symbol name, Expression right)
        {
            formulas.Add(new(name, right, []));
            scope[name.Text] = Expression.Name(name, right.Dimension);
        }

        private static Expression Claimed(Expression right, Dimension claimed) => right.Dimension == claimed ? right
            : throw new FormatException($"{right} is {right.Dimension}, not {claimed}");
    }
}
