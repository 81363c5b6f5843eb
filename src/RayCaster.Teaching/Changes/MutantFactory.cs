using static RayCaster.Teaching.Changes.MutationOperator;

namespace RayCaster.Teaching.Changes;

/// <summary>Makes all small edits of a section: each operator at each place of each formula.</summary>
internal sealed class MutantFactory
{
    /// <summary>Formulas that people write alike, so that a slip in one of them is often in all.</summary>
    private static readonly string[][] alike =
    [
        ["uc", "ur"], ["c", "r"], ["t0x", "t0y", "t0z", "t1x", "t1y", "t1z"], ["t0x", "t1x"], ["t0y", "t1y"], ["t0z", "t1z"], ["t0", "t1"],
        ["lo", "hi"], ["tmin", "tmax"], ["u", "v"], ["w", "u", "v"], ["first hit", "second hit"],
    ];

    private const double InAllAlike = 0.15, Everywhere = 0.2, OtherStyle = 0.15, ForeignName = 0.3, PerLevel = 0.3;

    /// <summary>What a formula costs that people are known to write.</summary>
    private const double Named = 1;

    /// <summary>How deep in an expression a part may lie that is written instead of it.</summary>
    private const int MaxDepth = 3;

    private static readonly Dictionary<Step, IReadOnlyList<Mutant>> known = [];

    private readonly Step section;
    private readonly List<Mutant> mutants = [];
    private UInt128 read; // the names in the formula whose mutants are made

    private MutantFactory(Step section) => this.section = section;

    /// <summary>All edits of a section of the slides.</summary>
    public static IReadOnlyList<Mutant> MutantsOf(Step section)
    {
        lock (known) return known.TryGetValue(section, out var mutants) ? mutants : known[section] = new MutantFactory(section).Make();
    }

    /// <summary>The edits of a section that are written in Mistakes.txt under a name.</summary>
    public static IEnumerable<Mutant> NamedMutantsOf(Step section)
    {
        var factory = new MutantFactory(section);
        var ids = factory.AddNamed();
        return factory.mutants
            .Select(mutant => mutant.Label is null ? mutant with { Label = ids.GetValueOrDefault(TextOf(mutant.Section)) } : mutant)
            .Where(mutant => mutant.Label is not null);
    }

    private List<Mutant> Make()
    {
        var scope = section.Scope.Values.ToDictionary(name => name.Symbol!);
        var slips = new List<Slip>[section.Formulas.Length];
        var isLoop = section.Kind == StepKind.Nearest; // its slips are the written ones
        for (var place = 0; place < section.Formulas.Length && !isLoop; place++)
        {
            var (name, right, parameters) = section.Formulas[place];
            read = right.Reads;
            Expression[] names = parameters.IsEmpty ? [.. scope.Values] : [.. parameters.Select(Expression.Parameter)];
            slips[place] = [.. SlipsIn(right, names, "")];
            foreach (var slip in slips[place]) Add(section.With(place, slip.Whole), place, slip, 0);
            foreach (var slip in Repeated(right, names)) Add(section.With(place, slip.Whole), place, slip, Everywhere);
            if (right.Dimension.Kind == ValueKind.Truth) AddConditions(place, scope.Values);
            scope[name] = Expression.Name(name, right.Dimension);
        }
        if (!isLoop)
        {
            AddAlike(slips);
            if (section.Kind != StepKind.Vectors) AddRenamed([.. scope.Values]);
            AddCrossings(scope);
        }
        var ids = AddNamed();
        var texts = new HashSet<string> { TextOf(section) };
        return [.. from mutant in mutants
                   orderby mutant.Cost
                   where texts.Add(string.Join('\n', mutant.Beside.Select(beside => beside.Name + TextOf(beside)).Prepend(TextOf(mutant.Section))))
                   select mutant.Beside.Length > 0 ? mutant
                       : mutant with { Label = ids.GetValueOrDefault(TextOf(mutant.Section)) ?? MutantLabels.IdOf(mutant) }];
    }

    private static string TextOf(Step section) => string.Join('\n', section.Formulas);

    private void Add(Step edited, int? place, Slip slip, double more) =>
        Add(edited, place, slip.Meant.ToString(), slip.Written.ToString(), slip.Operator, slip.Cost + more);

    private void Add(Step edited, int? place, string meant, string written, MutationOperator op, double cost)
    {
        var isFirstStyle = FormulaBook.Slides.StylesOf(section.Kind)[0] == section;
        mutants.Add(new(edited, place, meant, written, op, cost + (isFirstStyle ? 0 : OtherStyle)));
    }

    /// <summary>The same slip in all formulas that are alike.</summary>
    private void AddAlike(List<Slip>[] slips)
    {
        foreach (var names in alike)
        {
            int[] places = [.. names.Select(section.Find)];
            if (places.Contains(-1)) continue;
            foreach (var slip in slips[places[0]])
            {
                var edited = section.With(places[0], slip.Whole);
                foreach (var place in places.Skip(1))
                    edited = slips[place].Find(slip.IsLike) is { } same ? edited?.With(place, same.Whole) : null;
                if (edited is not null) Add(edited, places[0], slip, InAllAlike);
            }
        }
    }

    /// <summary>One name for another through the whole section, and two names exchanged.</summary>
    private void AddRenamed(Expression[] scope)
    {
        Expression[] given = [.. scope.Where(name => section.Formulas.All(formula => formula.Name != name.Symbol))];
        Expression[] used = [.. given.Where(name => (section.Reads & name.Symbol!.Bit) != 0)];
        foreach (var meant in used)
        {
            foreach (var written in given.Where(other => other != meant && other.Dimension == meant.Dimension))
            {
                Add(Renamed(name => name.Symbol == meant.Symbol ? written : name), null, $"{meant}", $"{written}", OtherName,
                    MutationOperators.CostOf(OtherName) + (IsOwn(written) ? Everywhere : ForeignName + Everywhere));
                if (used.Contains(written))
                    Add(Renamed(name => name.Symbol == meant.Symbol ? written : name.Symbol == written.Symbol ? meant : name), null,
                        $"{meant} and {written}", $"{written} and {meant}", Swapped, MutationOperators.CostOf(Swapped) + Everywhere);
            }
        }

        Step Renamed(Func<Expression, Expression> name) =>
            section.With([.. section.Formulas.Select(formula => formula with { Right = Rebuilt(formula.Right, name) })]);
    }

    private static Expression Rebuilt(Expression e, Func<Expression, Expression> name)
    {
        if (e.Operator == Operator.Name) return name(e);
        for (var i = 0; i < e.Operands.Length; i++)
        {
            var operand = Rebuilt(e.Operands[i], name);
            if (operand != e.Operands[i]) e = e.With(i, operand)!;
        }
        return e;
    }

    /// <summary>Whether a name is the section's own, not one of the camera's or the scene's.</summary>
    private bool IsOwn(Expression name) => name.Symbol!.Bit == 0 || section.Formulas.Any(formula => formula.Name == name.Symbol)
        || FormulaBook.Slides.IsGiven(section.Kind, name.Symbol);

    /// <summary>One condition more: that a number is positive, or negative.</summary>
    private void AddConditions(int place, IEnumerable<Expression> scope)
    {
        var right = section.Formulas[place].Right;
        foreach (var test in SignsOf(scope.Where(IsOwn)))
            Add(section.With(place, Expression.Of(Operator.And, right, test)!), place, $"{right}", $"{right} and {test}", ExtraCondition,
                MutationOperators.CostOf(ExtraCondition));
    }

    /// <summary>That a number is positive, and that it is negative, for each of some names.</summary>
    private static IEnumerable<Expression> SignsOf(IEnumerable<Expression> names) =>
        from name in names
        where name.Dimension.Kind == ValueKind.Number
        from op in (Operator[])[Operator.Greater, Operator.Less]
        select Expression.Of(op, name, Expression.Number(0));

    /// <summary>Which crossings a shape has.</summary>
    private void AddCrossings(Dictionary<Symbol, Expression> scope)
    {
        var formulas = section.Formulas;
        var near = section.Find(Formula.Near.Text);
        var far = section.Find(Formula.Far.Text);
        var when = section.Find(Formula.When.Text);
        if (when >= 0)
            Add(section.With(section.Formulas.RemoveAt(when)), when, $"{formulas[when].Right}", "no condition", MissingCondition, 1);
        else if (near >= 0)
        {
            foreach (var test in SignsOf(scope.Values.Where(name => section.Has(name.Symbol!))))
                Add(section.With(section.Formulas.Add(new(Formula.When, test, []))), near, "no condition", $"{test}", ExtraCondition,
                    MutationOperators.CostOf(ExtraCondition));
        }
        if (far < 0) return;
        var (t0, t1) = (formulas[near].Right, formulas[far].Right);
        Hits(OneCrossing, 1, t0);
        Hits(OneCrossing, 1, t1);
        Hits(Swapped, 1.1, t1, t0);
        Hits(OtherLaw, 1.6, Expression.Of(Operator.Divide, Expression.Of(Operator.Add, t0, t1)!, Expression.Number(2))!);

        void Hits(MutationOperator op, double cost, params Expression[] crossings)
        {
            var edited = section.Formulas.SetItem(near, new(Formula.Near, crossings[0], []));
            edited = crossings.Length > 1 ? edited.SetItem(far, new(Formula.Far, crossings[1], [])) : edited.RemoveAt(far);
            Add(section.With(edited), near, $"{t0}, {t1}", string.Join(", ", crossings.Select(t => $"{t}")), op, cost);
        }
    }

    /// <summary>The formulas that have a name, also those that no operator makes.</summary>
    private Dictionary<string, string> AddNamed()
    {
        var ids = new Dictionary<string, string>();
        foreach (var (id, step, beside) in MutantLabels.FormulasFor(section))
        {
            var edited = step.In(section);
            var name = step.Formulas[0].Name is "hits" ? Formula.Near.Text : step.Formulas[0].Name;
            var place = section.Find(name);
            Add(edited, place < 0 ? null : place, place < 0 ? "nothing" : $"{section.Formulas[place].Right}",
                $"{edited.Formulas[edited.Find(name)].Right}", OtherLaw, Named);
            if (beside.Length > 0) mutants[^1] = mutants[^1] with { Beside = beside, Label = id == "" ? null : id };
            else if (id != "") ids.TryAdd(TextOf(edited), id);
        }
        return ids;
    }

    /// <param name="Whole">The formula with the slip.</param>
    /// <param name="Path">The place in the formula's tree.</param>
    /// <param name="Detail">What distinguishes it from others of its operator at that place.</param>
    private sealed record Slip(
        Expression Whole, Expression Meant, Expression Written, MutationOperator Operator, string Path, string Detail, double Cost)
    {
        public bool IsLike(Slip other) => (Path, Operator, Detail) == (other.Path, other.Operator, other.Detail);
    }

    /// <summary>All slips in an expression, at each of its nodes.</summary>
    private IEnumerable<Slip> SlipsIn(Expression e, Expression[] names, string path)
    {
        foreach (var (op, written, detail, cost) in At(e, names))
            if (written is not null && written.Dimension.Kind == e.Dimension.Kind)
                yield return new(written, e, written, op, path, detail, MutationOperators.CostOf(op) + cost);
        for (var i = 0; i < e.Operands.Length; i++)
        {
            foreach (var slip in SlipsIn(e.Operands[i], names, path + i))
                if (e.With(i, slip.Whole) is { } whole) yield return slip with { Whole = whole };
        }
    }

    /// <summary>The same slip at every like place of a formula.</summary>
    private IEnumerable<Slip> Repeated(Expression whole, Expression[] names)
    {
        var alike = SlipsIn(whole, names, "").ToLookup(slip => (slip.Operator, slip.Detail, slip.Meant.Operator, slip.Meant.Symbol));
        foreach (var same in alike.Where(same => same.Count() > 1 && same.Key.Item1 is not Constant))
            yield return same.First() with { Whole = All(whole, same.Key) };

        Expression All(Expression e, (MutationOperator, string, Operator, Symbol?) key)
        {
            for (var i = 0; i < e.Operands.Length; i++) e = e.With(i, All(e.Operands[i], key)) ?? e;
            foreach (var (op, written, detail, _) in At(e, names))
                if ((op, detail, e.Operator, e.Symbol) == key && written is not null && written.Dimension.Kind == e.Dimension.Kind) return written;
            return e;
        }
    }

    /// <summary>What people may write instead of a node; null or another kind of value where the operator does not fit.</summary>
    private IEnumerable<(MutationOperator Operator, Expression? Written, string Detail, double Cost)> At(Expression e, Expression[] names)
    {
        var parts = e.Operands;
        switch (e.Operator)
        {
            case Operator.Number:
                foreach (var number in NumbersFor(e.Value)) yield return (Constant, Expression.Number(number), $"{number}", 0);
                yield break;
            case Operator.Name:
                foreach (var name in names.Where(name => name.Symbol != e.Symbol && name.Dimension.Kind == e.Dimension.Kind && !IsConstant(name)))
                    if (name.Dimension == e.Dimension || (IsOwn(name) && IsOwn(e)) || (name.Symbol!.Bit & read) != 0)
                        yield return (OtherName, name, name.Symbol!.Text, IsOwn(name) ? 0 : ForeignName);
                break;
            case Operator.Add:
                yield return (Sign, Expression.Of(Operator.Subtract, parts), "", 0);
                break;
            case Operator.Subtract:
                yield return (Sign, Expression.Of(Operator.Add, parts), "", 0);
                yield return (Swapped, Expression.Of(Operator.Subtract, parts[1], parts[0]), "", 0);
                yield return (LeftOut, Expression.Of(Operator.Negate, parts[1]), "−", 0.5);
                break;
            case Operator.Multiply:
                yield return (OtherOperation, Expression.Of(Operator.Divide, parts), "/", 0);
                yield return (OtherOperation, Expression.Of(Operator.Divide, parts[1], parts[0]), "\\", 0.1);
                yield return (OtherOperation, Expression.Of(Operator.Add, parts), "+", 0.5);
                break;
            case Operator.Divide:
                yield return (OtherOperation, Expression.Of(Operator.Multiply, parts), "·", 0);
                yield return (Swapped, Expression.Of(Operator.Divide, parts[1], parts[0]), "", 0.2);
                break;
            case Operator.X or Operator.Y or Operator.Z:
                foreach (var op in (Operator[])[Operator.X, Operator.Y, Operator.Z])
                    if (op != e.Operator) yield return (OtherComponent, Expression.Of(op, parts), $"{op}", 0);
                break;
            case Operator.Less or Operator.Greater or Operator.AtMost or Operator.AtLeast:
                var (turned, strict) = e.Operator switch
                {
                    Operator.Less => (Operator.AtLeast, Operator.AtMost),
                    Operator.Greater => (Operator.AtMost, Operator.AtLeast),
                    Operator.AtMost => (Operator.Greater, Operator.Less),
                    _ => (Operator.Less, Operator.Greater),
                };
                yield return (Turned, Expression.Of(turned, parts), "", 0);
                yield return (Strictness, Expression.Of(strict, parts), "", 0);
                yield return (MissingCondition, Always, "", 0);
                break;
            case Operator.And:
                yield return (AndOr, Expression.Of(Operator.Or, parts), "", 0);
                break;
            case Operator.Min or Operator.Max:
                yield return (MinMax, Expression.Of(e.Operator == Operator.Min ? Operator.Max : Operator.Min, parts), "", 0);
                break;
            case Operator.Tan:
                foreach (var op in (Operator[])[Operator.Sin, Operator.Cos]) yield return (OtherFunction, Expression.Of(op, parts), $"{op}", 0);
                break;
            case Operator.Vector:
                foreach (var (x, y, z) in ((int, int, int)[])[(2, 1, 0), (1, 0, 2), (0, 2, 1), (1, 2, 0), (2, 0, 1)])
                    yield return (Swapped, Expression.Of(Operator.Vector, parts[x], parts[y], parts[z]), $"{x}{y}{z}", x == 2 ? 0 : 0.2);
                break;
            case Operator.Call when e.Symbol!.Text == "cross":
                yield return (Swapped, Expression.Call("cross", parts[1], parts[0]), "", -0.1);
                yield return (OtherOperation, Expression.Of(Operator.Add, parts), "+", 0);
                yield return (OtherOperation, Expression.Of(Operator.Subtract, parts), "−", 0);
                break;
            case Operator.Call when e.Symbol!.Text == "dot" && section.Kind != StepKind.Vectors: // nothing there may call what calls it
                foreach (var part in parts) yield return (OtherOperation, Expression.Call("length", part), $"|{part}|", 0.2);
                break;
            case Operator.Call when e.Symbol!.Text == "length":
                yield return (Root, Expression.Call("dot", parts[0], parts[0]), "dot", -0.2);
                break;
        }
        if (e.Operator is not (Operator.X or Operator.Y or Operator.Z))
            foreach (var (part, path) in PartsOf(e, "")) yield return (LeftOut, part, path, PerLevel * (path.Length - 1));
        foreach (var (written, detail) in Bracketed(e)) yield return (Brackets, written, detail, 0);
        foreach (var around in Around(e)) yield return around;
    }

    /// <summary>Without a pair of brackets, and with one more.</summary>
    private static IEnumerable<(Expression?, string)> Bracketed(Expression e)
    {
        if (e.Operands is not [var a, var b]) yield break;
        switch (e.Operator)
        {
            case Operator.Multiply or Operator.Divide when IsSum(a): // (x + y) / b as x + y / b
                yield return (Of(a.Operator, a.Operands[0], Of(e.Operator, a.Operands[1], b)), "(a)");
                break;
            case Operator.Multiply when IsSum(b): // a (x + y) as a x + y
                yield return (Of(b.Operator, Of(Operator.Multiply, a, b.Operands[0]), b.Operands[1]), "(b)");
                break;
            case Operator.Divide when b.Operator == Operator.Multiply: // a / (x y) as a / x y
                yield return (Of(Operator.Multiply, Of(Operator.Divide, a, b.Operands[0]), b.Operands[1]), "(b)");
                break;
            case Operator.Subtract when IsSum(b): // a − (x + y) as a − x + y
                yield return (Of(b.Operator, Of(Operator.Subtract, a, b.Operands[0]), b.Operands[1]), "(b)");
                break;
        }
        if (IsSum(e) && b.Operator is Operator.Multiply or Operator.Divide) // a + x / y as (a + x) / y
            yield return (Of(b.Operator, Of(e.Operator, a, b.Operands[0]), b.Operands[1]), "b");
        if (IsSum(e) && a.Operator == Operator.Multiply) // x y + b as x (y + b)
            yield return (Of(Operator.Multiply, a.Operands[0], Of(e.Operator, a.Operands[1], b)), "a");

        static bool IsSum(Expression e) => e.Operator is Operator.Add or Operator.Subtract;

        static Expression? Of(Operator op, Expression? one, Expression? two) => one is null || two is null ? null : Expression.Of(op, one, two);
    }

    /// <summary>What is put around an expression.</summary>
    private IEnumerable<(MutationOperator, Expression?, string, double)> Around(Expression e)
    {
        var two = Expression.Number(2);
        switch (e.Dimension.Kind)
        {
            case ValueKind.Truth:
                yield return (Turned, Expression.Of(Operator.Not, e), "not", 0.4);
                yield break;
            case ValueKind.Number:
                yield return (Square, Expression.Of(Operator.Multiply, e, e), "", 0);
                yield return (Absolute, Expression.Of(Operator.Abs, e), "", 0);
                yield return (OtherOperation, Expression.Of(Operator.Divide, Expression.Number(1), e), "1/", 0.7);
                if (section.Kind is StepKind.File or StepKind.Pixel && e.Operator == Operator.Name)
                {
                    yield return (Shifted, Expression.Of(Operator.Add, e, Expression.Number(0.5)), "0.5", 0);
                    yield return (Shifted, Expression.Of(Operator.Add, e, Expression.Number(1)), "1", 0.1);
                    yield return (Shifted, Expression.Of(Operator.Subtract, e, Expression.Number(1)), "-1", 0.1);
                    if (section.Kind == StepKind.File && e.Symbol!.Text == "x")
                        yield return (Swapped, new ExpressionParser("width - 1 - x", section.Scope).Parse(), "", 0);
                }
                break;
            default:
                if (section.Kind != StepKind.Vectors)
                    yield return (Normalized, Expression.Call("normalize", e), "", section.Kind >= StepKind.Light ? 1 : 0);
                Expression[] axes = [Expression.Of(Operator.X, e)!, Expression.Of(Operator.Y, e)!, Expression.Of(Operator.Z, e)!];
                for (var i = 0; i < 3; i++)
                    yield return (LeftOut, Without(axes, i), $"{i}", 0.7);
                yield return (Swapped, Expression.Of(Operator.Vector, axes[0], axes[2], axes[1]), "xzy", 1);
                yield return (Swapped, Expression.Of(Operator.Vector, axes[1], axes[0], axes[2]), "yxz", 1);
                break;
        }
        if (section.Kind != StepKind.Bytes) // a negative picture is no slip: its bytes wrap round
            yield return (Sign, Expression.Of(Operator.Negate, e), "−", 0.2);
        yield return (Root, Expression.Of(Operator.Sqrt, e), "√", 0);
        yield return (Doubled, Expression.Of(Operator.Multiply, two, e), "", 0);
        yield return (Halved, Expression.Of(Operator.Divide, e, two), "", 0);
        var isOftenCut = e.Operator == Operator.Divide || section.Kind >= StepKind.Light;
        yield return (Truncated, Expression.Of(Operator.Truncate, e), "", isOftenCut ? 0 : 0.2);
    }

    private static Expression? Without(Expression[] axes, int axis) =>
        Expression.Of(Operator.Vector, [.. axes.Select((coordinate, i) => i == axis ? Expression.Number(0) : coordinate)]);

    /// <summary>Parts of an expression that people may write instead of it.</summary>
    private static IEnumerable<(Expression Part, string Path)> PartsOf(Expression e, string path)
    {
        for (var i = 0; i < e.Operands.Length; i++)
        {
            yield return (e.Operands[i], path + i);
            if (path.Length < MaxDepth)
                foreach (var inner in PartsOf(e.Operands[i], path + i)) yield return inner;
        }
    }

    private static IEnumerable<double> NumbersFor(double value)
    {
        double[] numbers = value switch
        {
            180 => [360, 90, 200, 100],
            255 => [256, 254, 128, 127, 100, 1],
            1.0000001 => [], // the slack of compared areas
            _ => [0, 1, 2, 0.5, 3, 4, 2 * value, value / 2, -value],
        };
        return numbers.Distinct().Where(number => number != value);
    }

    private static bool IsConstant(Expression name) => name.Symbol!.Text == "π";

    private static readonly Expression Always = Expression.Of(Operator.AtMost, Expression.Number(0), Expression.Number(0))!;
}
