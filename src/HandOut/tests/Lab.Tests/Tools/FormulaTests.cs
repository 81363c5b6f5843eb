using System.Reflection;

namespace Lab.Tests;

/// <summary>The tests of formulas: all of the steps but those of pictures.</summary>
public static class FormulaTests
{
    /// <summary>What the first test that fails says, of the first steps, of the last of them before the others; null if all pass.</summary>
    public static string FirstFailure(int steps) => FirstFailure(
        from type in typeof(FormulaTests).Assembly.GetTypes()
        where type.IsSubclassOf(typeof(StepTests)) && type.Name.StartsWith("Step") && int.Parse(type.Name[4..6]) <= steps
        orderby type.Name.StartsWith($"Step{steps:00}") descending, type.Name
        select type);

    internal static string FirstFailure(IEnumerable<Type> steps) => (
        from step in steps
        from test in step.GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly).OrderBy(test => test.MetadataToken)
        where test.IsDefined(typeof(FactAttribute)) && test.Name != "ThePictures" // as the file has them
        from arguments in ArgumentsOf(test)
        let message = Failure(step, test, arguments)
        where message != null
        select $"{step.Name}.{test.Name}: {message}").FirstOrDefault();

    /// <summary>Those of each InlineData; none for a test without parameters.</summary>
    private static IEnumerable<object[]> ArgumentsOf(MethodInfo test) => test.GetParameters().Length == 0
        ? [[]]
        : from data in test.GetCustomAttributesData()
          where data.AttributeType == typeof(InlineDataAttribute)
          select ((IEnumerable<CustomAttributeTypedArgument>)data.ConstructorArguments[0].Value).Select(argument => argument.Value).ToArray();

    /// <summary>The first line of a failing test's message; null if it passes.</summary>
    private static string Failure(Type step, MethodInfo test, object[] arguments)
    {
        using var tests = (StepTests)Activator.CreateInstance(step);
        try
        {
            test.Invoke(tests, arguments);
            return null;
        }
        catch (TargetInvocationException e)
        {
            return e.InnerException.Message.Split('\n')[0].TrimEnd();
        }
    }
}
