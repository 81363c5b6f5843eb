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
    /// <inheritdoc/>
    public override void Before(MethodInfo test)
    {
        var trait = test.ReflectedType.CustomAttributes.First(attribute => attribute.AttributeType == typeof(TraitAttribute));
        var step = int.Parse((string)trait.ConstructorArguments[1].Value, CultureInfo.InvariantCulture);
        if (Todo.Endless is var (stepOfBody, message) && stepOfBody <= step) Assert.Fail(message);
    }
}
