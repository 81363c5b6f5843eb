using System.Collections.Concurrent;
using System.Globalization;
using System.Reflection;
using Xunit.Sdk;

namespace Lab.Tests;

/// <summary>
/// Fails the tests of a class if a body of their step, or of an earlier one, does not end: they would wait for it, and the run would be stopped.
/// </summary>
[AttributeUsage(AttributeTargets.Class)]
public sealed class EndsAttribute : BeforeAfterTestAttribute
{
    private static readonly ConcurrentDictionary<int, MethodInfo> first = [];

    /// <inheritdoc/>
    public override void Before(MethodInfo test)
    {
        var trait = test.ReflectedType.CustomAttributes.First(attribute => attribute.AttributeType == typeof(TraitAttribute));
        var step = int.Parse((string)trait.ConstructorArguments[1].Value, CultureInfo.InvariantCulture);
        // A body that calls itself without end ends the process here. The table of steps then knows by this line which test was running.
        if (first.TryAdd(step, test)) Console.Error.WriteLine($"begun: {test.ReflectedType.FullName}.{test.Name}()");
        if (Todo.Endless(step) is { } endless) Assert.Fail(endless);
    }
}
