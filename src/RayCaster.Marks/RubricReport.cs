namespace RayCaster.Marks;

/// <summary>A rubric in words for the teacher.</summary>
public static class RubricReport
{
    /// <summary>Lines of text: the items with their points, and the mistakes that no scene can show.</summary>
    public static string Text(Rubric rubric)
    {
        var text = new StringBuilder();
        text.AppendLine($"{rubric.Title}: {rubric.Items.Count} items, {MarksTable.Number(rubric.Points)} points, {rubric.Scenes.Count} scenes.");
        var hidden = false;
        foreach (var item in rubric.Items)
        {
            string[] unseen = [.. item.Mistakes.Where(mistake => !rubric.Scenes.Any(scene => scene.Shows(mistake)))];
            hidden |= unseen.Length > 0;
            text.AppendLine($"  {MarksTable.Number(item.Points),4}  {item.Name}" +
                $"{(unseen.Length > 0 ? $"; no scene shows {string.Join(", ", unseen)}" : "")}");
        }
        string[] free = [.. MistakeCatalog.All.Where(mistake => rubric.ItemOf(mistake.Id) is null).Select(mistake => mistake.Id)];
        if (free.Length > 0) text.Wrap("", $"These mistakes cost nothing: {string.Join(", ", free)}.");
        text.AppendLine(hidden
            ? "What no scene shows costs nobody anything: \"raycaster check\" says what to change in a scene."
            : "Each mistake of an item shows in one of the scenes at least.");
        return text.ToString();
    }
}
