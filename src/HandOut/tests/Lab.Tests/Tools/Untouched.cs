using System.Diagnostics;
using System.Reflection;

namespace Lab.Tests;

/// <summary>The numbers of objects before a call that must leave them as they are.</summary>
[StackTraceHidden] // the trace of a failure begins in the test
public sealed class Untouched
{
    private readonly (string Name, object It)[] objects;

    private readonly (string Name, double Number)[] before;

    /// <param name="objects">With the names that messages give them. The hit of a ray may change.</param>
    public Untouched(params (string Name, object It)[] objects)
    {
        this.objects = objects;
        before = Numbers();
    }

    /// <summary>Fails if the call has changed a number.</summary>
    public void Check(string slide)
    {
        foreach (var ((name, was), (_, now)) in before.Zip(Numbers()))
            if (!was.Equals(now))
                Assert.Fail($"""
                    the call has changed {name} from {RayAssert.Text(was)} to {RayAssert.Text(now)}.
                      L = ray.Origin makes no copy: both names mean one vector, so L.X = … changes the ray, too.
                      Use operators: they make new vectors.
                      {RayAssert.Cite(slide)}
                    """);
    }

    private (string, double)[] Numbers() => [.. objects.SelectMany(of => NumbersOf(of.Name, of.It))];

    private static IEnumerable<(string, double)> NumbersOf(string name, object value) => value switch
    {
        double number => [(name, number)],
        Ray ray => [.. NumbersOf($"{name}.Origin", ray.Origin), .. NumbersOf($"{name}.Direction", ray.Direction)],
        Vector3 or Color or Model or Camera =>
            from field in value.GetType().GetFields(BindingFlags.Public | BindingFlags.Instance)
            from number in NumbersOf($"{name}.{field.Name}", field.GetValue(value))
            select number,
        _ => [],
    };
}
