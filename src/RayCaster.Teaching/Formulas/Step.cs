namespace RayCaster.Teaching.Formulas;

/// <summary>The formulas of one step, in one right style or with an edit.</summary>
/// <param name="style">The way in which it is written; empty for the only one.</param>
/// <param name="slide">The slide's title.</param>
/// <param name="scope">The names that its first formula can read.</param>
internal sealed class Step(
    StepKind kind, string style, string slide, IReadOnlyDictionary<string, Expression> scope, ImmutableArray<Formula> formulas)
{
    public StepKind Kind => kind;

    public string Style => style;

    public string Slide => slide;

    public IReadOnlyDictionary<string, Expression> Scope => scope;

    public ImmutableArray<Formula> Formulas => formulas;

    /// <summary>All that its formulas read.</summary>
    public UInt128 Reads { get; } = formulas.Aggregate(UInt128.Zero, (all, formula) => all | formula.Right.Reads);

    /// <summary>All that they compute.</summary>
    public UInt128 Names { get; } = formulas.Aggregate(UInt128.Zero, (all, formula) => all | formula.Name.Bit);

    /// <summary>As its text calls it.</summary>
    public string Name => $"{kind.ToString().ToLowerInvariant()} {style}".TrimEnd();

    /// <summary>The place of a formula; −1 if no formula has the name.</summary>
    public int Find(string name)
    {
        for (var i = 0; i < formulas.Length; i++)
            if (formulas[i].Name.Text == name) return i;
        return -1;
    }

    public bool Has(Symbol name)
    {
        foreach (var formula in formulas)
            if (formula.Name == name) return true;
        return false;
    }

    public Step With(ImmutableArray<Formula> others) => new(kind, style, slide, scope, others);

    /// <summary>The same with another formula, which may read what comes before it; at the end, if none has the name.</summary>
    /// <param name="name">Its name; "hits" for the crossings, with a comma between two.</param>
    public Step With(string name, string right)
    {
        if (name == "hits")
        {
            var crossings = right.Split(", ");
            var near = With(Formula.Near.Text, crossings[0]);
            return crossings is [_, var far] ? near.With(Formula.Far.Text, far)
                : near.With([.. near.Formulas.Where(formula => formula.Name != Formula.Far)]);
        }
        var place = Find(name);
        var names = new Dictionary<string, Expression>(scope);
        foreach (var (before, own, _) in place < 0 ? formulas : formulas[..place])
            names[before.Text] = Expression.Name(before, own.Dimension);
        if (place >= 0)
            foreach (var parameter in formulas[place].Parameters) names[parameter.Text] = Expression.Parameter(parameter);
        var expression = new ExpressionParser(right, names, allUnits: true).Parse();
        return place >= 0 ? With(place, expression) : With(formulas.Add(new(Symbol.From(name), expression, [])));
    }

    /// <summary>The same with the edits of another one, too, or the other one if this has none.</summary>
    /// <returns>Null if both edit the same part of a formula, or have different styles.</returns>
    public Step? Merged(Step edited)
    {
        var right = FormulaBook.Slides[kind, edited.Style];
        if (FormulaBook.Slides[kind, style] == this || this == edited) return edited;
        if (style != edited.Style) return null;
        var merged = formulas;
        foreach (var name in right.Formulas.Concat(edited.Formulas).Select(formula => formula.Name).Distinct())
        {
            var meant = Of(right.Formulas, name);
            var written = Of(edited.Formulas, name);
            if (ReferenceEquals(meant?.Right, written?.Right)) continue;
            var own = Of(merged, name);
            if (ReferenceEquals(own?.Right, meant?.Right))
                merged = own is null ? merged.Add(written!) : written is null ? merged.Remove(own) : merged.Replace(own, written);
            else if (own is not null && meant is not null && written is not null && own.Right.Merged(meant.Right, written.Right) is { } both)
                merged = merged.Replace(own, own with { Right = both });
            else return null;
        }
        // What one of both has removed, the other may read.
        var names = merged.Aggregate(UInt128.Zero, (all, formula) => all | formula.Name.Bit);
        var removed = formulas.Concat(edited.Formulas).Aggregate(UInt128.Zero, (all, formula) => all | formula.Name.Bit) & ~names;
        return merged.Any(formula => (formula.Right.Reads & removed) != 0) ? null : With(merged);

        static Formula? Of(ImmutableArray<Formula> all, Symbol name) => all.FirstOrDefault(formula => formula.Name == name);
    }

    public Step With(int place, Expression right) => With(formulas.SetItem(place, formulas[place] with { Right = right }));
}
