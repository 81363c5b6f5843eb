namespace RayCaster.Teaching.Changes;

/// <summary>Makes all small edits of a step: each operator at each place of each formula.</summary>
internal sealed class MutationFactory
{
    private const double InAllAlike = 0.15, Everywhere = 0.2, OtherStyle = 0.15, ForeignName = 0.3, PerLevel = 0.3;

    /// <summary>What a formula costs that people are known to write.</summary>
    private const double Named = 1;

    /// <summary>How deep in an expression a part may lie that is written instead of it.</summary>
    private const int MaxDepth = 3;

    private static readonly Dictionary<Step, IReadOnlyList<Mutation>> known = [];

    private readonly Step step;
    private readonly MutationBook book;
    private readonly List<Mutation> mutations = [];
    private UInt128 read; // the names in the formula whose mutations are made

    private MutationFactory(Step step, MutationBook book) => (this.step, this.book) = (step, book);

    /// <summary>All edits of a step of the slides.</summary>
    public static IReadOnlyList<Mutation> MutationsOf(Step step)
    {
        lock (known) return known.TryGetValue(step, out var mutations) ? mutations : known[step] = MutationsOf(step, MutationBook.Slips);
    }

    /// <summary>All edits of a step by the slips of a text.</summary>
    public static IReadOnlyList<Mutation> MutationsOf(Step step, MutationBook slips) => new MutationFactory(step, slips).Make();

    /// <summary>The edits of a step that are written in Mistakes.txt under a name.</summary>
    public static IEnumerable<Mutation> NamedMutationsOf(Step step)
    {
        var factory = new MutationFactory(step, MutationBook.Slips);
        var ids = factory.AddNamed();
        return factory.mutations
            .Select(mutation => mutation.Label is null ? mutation with { Label = ids.GetValueOrDefault(TextOf(mutation.Step)) } : mutation)
            .Where(mutation => mutation.Label is not null);
    }

    private List<Mutation> Make()
    {
        var scope = step.Scope.Values.ToDictionary(name => name.Symbol!);
        var slips = new List<Slip>[step.Formulas.Length];
        var isLoop = step.Kind == StepKind.Nearest; // its slips are the written ones
        for (var place = 0; place < step.Formulas.Length && !isLoop; place++)
        {
            var (name, right, parameters) = step.Formulas[place];
            read = right.Reads;
            Expression[] names = parameters.IsEmpty ? [.. scope.Values] : [.. parameters.Select(Expression.Parameter)];
            slips[place] = [.. SlipsIn(right, names, "")];
            foreach (var slip in slips[place]) Add(step.With(place, slip.Whole), place, slip, 0);
            foreach (var slip in Repeated(right, names)) Add(step.With(place, slip.Whole), place, slip, Everywhere);
            if (right.Dimension.Kind == ValueKind.Truth) AddConditions(place, scope.Values);
            scope[name] = Expression.Name(name, right.Dimension);
        }
        if (!isLoop)
        {
            AddAlike(slips);
            if (step.Kind != StepKind.Vectors) AddRenamed([.. scope.Values]);
            AddCrossings(scope);
        }
        var ids = AddNamed();
        var texts = new HashSet<string> { TextOf(step) };
        return [.. from mutation in mutations
                   orderby mutation.Cost
                   where texts.Add(string.Join('\n', mutation.Beside.Select(beside => beside.Name + TextOf(beside)).Prepend(TextOf(mutation.Step))))
                   select mutation.Beside.Length > 0 ? mutation
                       : mutation with { Label = ids.GetValueOrDefault(TextOf(mutation.Step)) ?? MutationLabels.IdOf(mutation) }];
    }

    private static string TextOf(Step step) => string.Join('\n', step.Formulas);

    private void Add(Step edited, int? place, Slip slip, double more) =>
        Add(edited, place, slip.Meant.ToString(), slip.Written.ToString(), slip.Operator, slip.Cost + more);

    private void Add(Step edited, int? place, string meant, string written, string slip, double more) =>
        Add(edited, place, meant, written, book[slip], book[slip].Cost + more);

    private void Add(Step edited, int? place, string meant, string written, MutationOperator op, double cost)
    {
        var isFirstStyle = FormulaBook.Slides.StylesOf(step.Kind)[0] == step;
        mutations.Add(new(edited, place, meant, written, op, cost + (isFirstStyle ? 0 : OtherStyle)));
    }

    /// <summary>The same slip in all formulas that are alike.</summary>
    private void AddAlike(List<Slip>[] slips)
    {
        foreach (var names in book.Alike)
        {
            int[] places = [.. names.Select(step.Find)];
            if (places.Contains(-1)) continue;
            foreach (var slip in slips[places[0]])
            {
                var edited = step.With(places[0], slip.Whole);
                foreach (var place in places.Skip(1))
                    edited = slips[place].Find(slip.IsLike) is { } same ? edited?.With(place, same.Whole) : null;
                if (edited is not null) Add(edited, places[0], slip, InAllAlike);
            }
        }
    }

    /// <summary>One name for another through the whole step, and two names exchanged.</summary>
    private void AddRenamed(Expression[] scope)
    {
        Expression[] given = [.. scope.Where(name => step.Formulas.All(formula => formula.Name != name.Symbol))];
        Expression[] used = [.. given.Where(name => (step.Reads & name.Symbol!.Bit) != 0)];
        foreach (var meant in used)
        {
            foreach (var written in given.Where(other => other != meant && other.Dimension == meant.Dimension))
            {
                Add(Renamed(name => name.Symbol == meant.Symbol ? written : name), null, $"{meant}", $"{written}", "OtherName",
                    IsOwn(written) ? Everywhere : ForeignName + Everywhere);
                if (used.Contains(written))
                    Add(Renamed(name => name.Symbol == meant.Symbol ? written : name.Symbol == written.Symbol ? meant : name), null,
                        $"{meant} and {written}", $"{written} and {meant}", "Swapped", Everywhere);
            }
        }

        Step Renamed(Func<Expression, Expression> name) =>
            step.With([.. step.Formulas.Select(formula => formula with { Right = Rebuilt(formula.Right, name) })]);
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

    /// <summary>Whether a name is the step's own, not one of the camera's or the scene's.</summary>
    private bool IsOwn(Expression name) => name.Symbol!.Bit == 0 || step.Formulas.Any(formula => formula.Name == name.Symbol)
        || FormulaBook.Slides.IsGiven(step.Kind, name.Symbol);

    /// <summary>One condition more: that a number is positive, or negative.</summary>
    private void AddConditions(int place, IEnumerable<Expression> scope)
    {
        var right = step.Formulas[place].Right;
        foreach (var test in SignsOf(scope.Where(IsOwn)))
            Add(step.With(place, Expression.Create(Operator.And, right, test)!), place, $"{right}", $"{right} and {test}", "ExtraCondition", 0);
    }

    /// <summary>That a number is positive, and that it is negative, for each of some names.</summary>
    private static IEnumerable<Expression> SignsOf(IEnumerable<Expression> names) =>
        from name in names
        where name.Dimension.Kind == ValueKind.Number
        from op in (Operator[])[Operator.Greater, Operator.Less]
        select Expression.Create(op, name, Expression.Number(0));

    /// <summary>Which crossings a shape has.</summary>
    private void AddCrossings(Dictionary<Symbol, Expression> scope)
    {
        var formulas = step.Formulas;
        var near = step.Find(Formula.Near.Text);
        var far = step.Find(Formula.Far.Text);
        var when = step.Find(Formula.When.Text);
        if (when >= 0)
            Add(step.With(step.Formulas.RemoveAt(when)), when, $"{formulas[when].Right}", "no condition", "MissingCondition", 0);
        else if (near >= 0)
        {
            foreach (var test in SignsOf(scope.Values.Where(name => step.Has(name.Symbol!))))
                Add(step.With(step.Formulas.Add(new(Formula.When, test, []))), near, "no condition", $"{test}", "ExtraCondition", 0);
        }
        if (far < 0) return;
        var (t0, t1) = (formulas[near].Right, formulas[far].Right);
        Hits("OneCrossing", 1, t0);
        Hits("OneCrossing", 1, t1);
        Hits("Swapped", 1.1, t1, t0);
        Hits("OtherLaw", 1.6, Expression.Create(Operator.Divide, Expression.Create(Operator.Add, t0, t1)!, Expression.Number(2))!);

        void Hits(string slip, double cost, params Expression[] crossings)
        {
            var edited = step.Formulas.SetItem(near, new(Formula.Near, crossings[0], []));
            edited = crossings.Length > 1 ? edited.SetItem(far, new(Formula.Far, crossings[1], [])) : edited.RemoveAt(far);
            Add(step.With(edited), near, $"{t0}, {t1}", string.Join(", ", crossings.Select(t => $"{t}")), book[slip], cost);
        }
    }

    /// <summary>The formulas that have a name, also those that no operator makes.</summary>
    private Dictionary<string, string> AddNamed()
    {
        var ids = new Dictionary<string, string>();
        foreach (var (id, written, beside) in MutationLabels.FormulasFor(step))
        {
            var edited = written.In(step);
            var name = written.Formulas[0].Name is "hits" ? Formula.Near.Text : written.Formulas[0].Name;
            var place = step.Find(name);
            Add(edited, place < 0 ? null : place, place < 0 ? "nothing" : $"{step.Formulas[place].Right}",
                $"{edited.Formulas[edited.Find(name)].Right}", book["OtherLaw"], Named);
            if (beside.Length > 0) mutations[^1] = mutations[^1] with { Beside = beside, Label = id == "" ? null : id };
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
            yield return new(written, e, written, op, path, detail, op.Cost + cost);
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
        foreach (var same in alike.Where(same => same.Count() > 1 && same.Key.Item3 != Operator.Number))
            yield return same.First() with { Whole = All(whole, same.Key) };

        Expression All(Expression e, (MutationOperator, string, Operator, Symbol?) key)
        {
            for (var i = 0; i < e.Operands.Length; i++) e = e.With(i, All(e.Operands[i], key)) ?? e;
            foreach (var (op, written, detail, _) in At(e, names))
                if ((op, detail, e.Operator, e.Symbol) == key) return written;
            return e;
        }
    }

    /// <summary>What people may write instead of a node. Of two slips that write the same the first counts: what is put around it comes last.
    /// </summary>
    private IEnumerable<(MutationOperator Operator, Expression Written, string Detail, double Cost)> At(Expression e, Expression[] names)
    {
        if (e.Operator == Operator.Name)
            foreach (var name in names.Where(name => name.Symbol != e.Symbol && name.Dimension.Kind == e.Dimension.Kind && !IsConstant(name)))
                if (name.Dimension == e.Dimension || (IsOwn(name) && IsOwn(e)) || (name.Symbol!.Bit & read) != 0)
                    yield return (book["OtherName"], name, name.Symbol!.Text, IsOwn(name) ? 0 : ForeignName);
        var written = book.Written(step.Kind, e).ToLookup(pair => pair.Rule.IsAround,
            pair => (pair.Rule.Mutation, pair.Written, $"{pair.Rule.Slip}", pair.Rule.More));
        foreach (var slip in written[false]) yield return slip;
        if (e.Operator is not (Operator.X or Operator.Y or Operator.Z))
            foreach (var (part, path) in PartsOf(e, ""))
                if (part.Dimension.Kind == e.Dimension.Kind) yield return (book["LeftOut"], part, path, PerLevel * (path.Length - 1));
        foreach (var slip in written[true]) yield return slip;
    }

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

    private static bool IsConstant(Expression name) => name.Symbol!.Text == "π";
}
