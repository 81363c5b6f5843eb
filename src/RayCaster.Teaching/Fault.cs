using System.Diagnostics;

namespace RayCaster.Teaching;

/// <summary>The message for an exception that no code expects. If the course library was changed, the change is the likely cause.</summary>
public static class Fault
{
    /// <param name="program">The program's name, with which the message begins.</param>
    public static string InWords(string program, Exception fault) => InWords(program, fault, ScalarRenderer.IsChanged);

    internal static string InWords(string program, Exception fault, bool isChanged)
    {
        if (fault is AggregateException { InnerException: { } first }) fault = first; // of several threads
        return isChanged
            ? $"{program}: {fault.GetType().Name}{Place(fault)}: {fault.Message}\n" +
                "src/RayCaster was changed, and the change may be the cause: \"git diff src/RayCaster\" shows it."
            : $"{program}: internal error: {fault.Message}\nThis is a fault of {program}, please report it.";
    }

    /// <summary>The class of the course library that failed; empty if it was compiled into its caller, and no frame of the stack names it.</summary>
    private static string Place(Exception fault) =>
        new StackTrace(fault).GetFrames().Select(frame => frame.GetMethod()?.DeclaringType)
            .FirstOrDefault(type => type?.Assembly == typeof(Scene).Assembly) is { } type ? $" in {type.Name.Split('`')[0]}" : "";
}
