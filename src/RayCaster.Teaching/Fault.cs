using System.Diagnostics;

namespace RayCaster.Teaching;

/// <summary>The message for an exception that no code expects. If the course library throws it, a change there is the likely cause.</summary>
public static class Fault
{
    /// <param name="program">The program's name, with which the message begins.</param>
    public static string InWords(string program, Exception fault)
    {
        while (fault is AggregateException or TypeInitializationException && fault.InnerException is { } cause) fault = cause;
        var place = Place(fault);
        return place is not null || fault is EngineDisagreesException
            ? $"{program}: {(place is null ? "" : $"{fault.GetType().Name} in {place}: ")}{fault.Message}\n" +
                "If you changed src/RayCaster, the change may be the cause: \"git diff src/RayCaster\" shows it."
            : $"{program}: internal error: {fault.Message}\nThis is a fault of {program}, please report it.";
    }

    /// <summary>The class of the course library that failed; null if no frame of the stack is of the library.</summary>
    private static string? Place(Exception fault) =>
        new StackTrace(fault).GetFrames().Select(frame => frame.GetMethod()?.DeclaringType)
            .FirstOrDefault(type => type?.Assembly == typeof(Scene).Assembly) is { } type ? type.Name.Split('`')[0] : null;
}
