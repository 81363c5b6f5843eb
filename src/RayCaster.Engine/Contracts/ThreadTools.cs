namespace RayCaster.Engine;

/// <summary>The tools that the views of one thread share: one of each kind, made on first use.</summary>
internal sealed class ThreadTools
{
    private readonly Dictionary<Type, object> tools = [];

    public T Of<T>() where T : class, new()
    {
        if (!tools.TryGetValue(typeof(T), out var tool)) tools.Add(typeof(T), tool = new T());
        return (T)tool;
    }
}
