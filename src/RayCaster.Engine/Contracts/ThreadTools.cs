namespace RayCaster.Engine;

/// <summary>One thread's tools that several views share: one of each kind, made when a view first needs it.</summary>
internal sealed class ThreadTools
{
    private readonly Dictionary<Type, object> tools = [];

    public T Of<T>() where T : class, new()
    {
        if (!tools.TryGetValue(typeof(T), out var tool)) tools.Add(typeof(T), tool = new T());
        return (T)tool;
    }
}
