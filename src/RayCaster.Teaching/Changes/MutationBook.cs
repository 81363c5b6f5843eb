namespace RayCaster.Teaching.Changes;

/// <summary>Slips.txt: what people write instead of a part of a formula.</summary>
internal sealed class MutationBook
{
    private static readonly Lazy<MutationBook> slips = new(() => new(FormulaBook.TextOf("Slips.txt")));

    private readonly Dictionary<string, MutationOperator> operators = [];
    private readonly Dictionary<StepKind, List<RewriteRule>> rules =
        Enum.GetValues<StepKind>().ToDictionary(step => step, _ => new List<RewriteRule>());

    /// <exception cref="FormatException">What is wrong, and where.</exception>
    public MutationBook(string text)
    {
        var blocks = text.Split("\n[");
        Alike = [.. LinesOf(blocks[0]).Select(line => line.Split(' ', 2)[1].Split(", "))];
        foreach (var block in blocks.Skip(1)) Read([.. LinesOf(block)]);
    }

    /// <summary>The slips of the text beside this file.</summary>
    public static MutationBook Slips => slips.Value;

    /// <summary>The names of formulas that people write alike, so that a slip in one of them is often in all.</summary>
    public IReadOnlyList<string[]> Alike { get; }

    /// <summary>The slip of a name.</summary>
    public MutationOperator this[string name] => operators.TryGetValue(name, out var found) ? found
        : throw new FormatException($"unknown slip '{name}'; there are {string.Join(", ", operators.Keys)}");

    /// <summary>What people write instead of an expression of a step, in the order of the text.</summary>
    public IEnumerable<(RewriteRule Rule, Expression Written)> Written(StepKind step, Expression e)
    {
        RewriteRule? first = null;
        foreach (var rule in rules[step])
        {
            if (rule.Apply(e) is not { } written) continue;
            if (first?.Mutation != rule.Mutation) first = rule;
            if (e.Operator == Operator.Number && rule.Slip.Line != first.Slip.Line) continue; // of each slip, the first line is for it
            if (written.ToString() != e.ToString()) yield return (rule, written);
        }
    }

    private static IEnumerable<string> LinesOf(string block) =>
        block.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries).Where(line => line[0] != '#');

    private void Read(string[] lines)
    {
        var name = lines[0].TrimEnd(']');
        var words = new Dictionary<string, string> { ["answer"] = "WRITTEN was written instead of MEANT" };
        foreach (var line in lines.Skip(1))
            if (line.Split(' ', 2) is [("cost" or "question" or "answer") and var word, var rest]) words[word] = rest;
        try
        {
            if (!words.ContainsKey("cost") || !words.ContainsKey("question")) throw new FormatException("a slip has a cost and a question");
            var slip = new MutationOperator(name, NumberOf(words["cost"]), words["question"], words["answer"], lines.Contains("size"));
            operators.Add(name, slip);
            for (var i = 1; i < lines.Length; i++)
                if (lines[i].Contains('→', StringComparison.Ordinal)) ReadRules(lines[i], i, slip);
        }
        catch (FormatException error)
        {
            throw new FormatException($"Slips.txt: [{name}]: {error.Message}", error);
        }
    }

    /// <summary>Reads a line "in STEPS: LEFT → RIGHT [COST] | RIGHT; LEFT → RIGHT".</summary>
    private void ReadRules(string line, int number, MutationOperator slip)
    {
        var steps = Enum.GetValues<StepKind>();
        if (line.IndexOf(": ", StringComparison.Ordinal) is > 0 and var colon)
        {
            var isNot = line.StartsWith("not in ", StringComparison.Ordinal);
            StepKind[] named = [.. line[(isNot ? 7 : 3)..colon].Split(", ").Select(StepOf)];
            steps = isNot ? [.. steps.Except(named)] : named;
            line = line[(colon + 2)..];
        }
        foreach (var rule in line.Split("; "))
        {
            if (rule.Split('→', StringSplitOptions.TrimEntries) is not [var left, var right])
                throw new FormatException($"'{rule}' where a rule is expected, as in 'a + b → a − b'");
            var choices = right.Split(" | ");
            for (var i = 0; i < choices.Length; i++)
            {
                var (written, more) = choices[i].Split(" [") is [var before, var cost] ? (before, NumberOf(cost.TrimEnd(']'))) : (choices[i], 0);
                var read = RulesOf(left, written, steps).ConvertAll(pair => new RewriteRule(slip, pair.Left, pair.Right, more, (number, i)));
                foreach (var step in steps) rules[step].AddRange(read);
            }
        }
    }

    /// <summary>The rule for each kind of value that its letters can have.</summary>
    private static List<(Expression Left, Expression Right)> RulesOf(string left, string right, StepKind[] steps)
    {
        var names = steps is [var only] ? FormulaBook.Slides.StylesOf(only)[0].Scope : new Dictionary<string, Expression>();
        string[] words = new string([.. left.Select(c => char.IsLetter(c) ? c : ' ')]).Split(' ');
        IEnumerable<Dictionary<string, Expression>> scopes = [new(names)];
        foreach (var (letter, kinds) in RewriteRule.Letters.Where(letter => words.Contains(letter.Key)))
            scopes =
            [
                .. from scope in scopes
                   from kind in kinds
                   select new Dictionary<string, Expression>(scope) { [letter] = RewriteRule.Letter(letter, kind) },
            ];
        List<(Expression, Expression)> found = [];
        FormatException? wrong = null;
        foreach (var scope in scopes)
        {
            try
            {
                var (meant, written) = (Parse(left, scope), Parse(right, scope));
                if (meant.Dimension.Kind == written.Dimension.Kind) found.Add((meant, written));
            }
            catch (FormatException error)
            {
                wrong = error; // no operation takes operands of these kinds
            }
        }
        return found.Count > 0 ? found : throw wrong ?? new FormatException($"{right} is of another kind than {left}");

        static Expression Parse(string text, IReadOnlyDictionary<string, Expression> scope) =>
            new ExpressionParser(text, scope, allUnits: true).Parse();
    }

    private static StepKind StepOf(string word) => Enum.TryParse<StepKind>(word, ignoreCase: true, out var step) ? step
        : throw new FormatException($"unknown step '{word}'; there are {string.Join(", ", Enum.GetNames<StepKind>()).ToLowerInvariant()}");

    private static double NumberOf(string text) => double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) ? number
        : throw new FormatException($"'{text}' where a number is expected");
}
