using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>Somebody uses the page and reads, on a laptop and on a phone. The page is the same from each host, so it is asked of one.</summary>
[Collection("server")]
public class ReadingTests(Chromium chromium) : HostTests
{
    private const int Laptop = 1400, Phone = 360;

    private const string Distance = """
        () => {
            const { position, target } = JSON.parse(`{${document.getElementById('camera-json').textContent}}`);
            return Math.hypot(...position.map((value, i) => value - target[i]));
        }
        """;

    /// <summary>Where the parts of the page are, and how high.</summary>
    private const string Places = """
        [...document.querySelectorAll('section, figcaption, #screen')].map(part => {
            const { top, height } = part.getBoundingClientRect();
            return `${part.id || part.tagName} ${top} ${height}`;
        })
        """;

    [BrowserTheory]
    [InlineData(Laptop)]
    [InlineData(Phone)]
    public async Task ThePictureStaysInSightWhileTheTextScrolls(int width)
    {
        await ResizeAsync(width);
        await Page.ExplainAsync();
        await Page.DropWrongAsync(40, 30);
        foreach (var part in new[] { "#models", "#pixel", "#comparison", "#diagnose" })
        {
            await Page.EvaluateFunctionAsync("part => document.querySelector(part).scrollIntoView({ behavior: 'instant' })", part);
            await IsInSightAsync("#stage");
            await IsInSightAsync(part, isWhole: false);
        }
    }

    [BrowserTheory]
    [InlineData(Laptop)]
    [InlineData(Phone)]
    public async Task WhatAClickOrADroppedPictureOpensComesIntoSight(int width)
    {
        await ResizeAsync(width);
        await Page.ClickOnPixelAsync(20, 14, 40, 30);
        await IsInSightAsync("#pixel-head");
        await IsInSightAsync("#stage");
        await Page.DropWrongAsync(40, 30);
        await IsInSightAsync("#mine-said");
        await Page.ClickOnAsync("#mine-worst");
        await IsInSightAsync("#pixel-head");
    }

    [BrowserTheory]
    [InlineData(Laptop)]
    [InlineData(Phone)]
    public async Task NothingMovesWhileOnePointsAtPixels(int width)
    {
        await ResizeAsync(width);
        var before = await Page.EvaluateExpressionAsync<string[]>(Places);
        foreach (var (column, line, told) in new[] { (20, 14, "column 20, line 14 (row 15)"), (2, 2, "column 2, line 2 (row 27)") })
        {
            await Page.HoverOnPixelAsync(column, line, 40, 30);
            await Page.SaysAsync(told);
            Assert.Equal(before, await Page.EvaluateExpressionAsync<string[]>(Places));
        }
    }

    [BrowserFact]
    public async Task AnExplanationOpensWithItsAnswerAndTheRestIsFolded()
    {
        await Page.ClickOnPixelAsync(20, 14, 40, 30);
        await Page.SaysAsync("Column 20, line 14");
        var (head, gist) = (await Page.TextOfAsync("#pixel-head"), await Page.TextOfAsync("#pixel-gist"));
        Assert.Matches(@"<img src=x onerror=alert\(1\)> at t = 5\.\d+, bytes \d+ \d+ \d+", head);
        Assert.Matches(@"^L = C − P = .*\nt = [\d.]+ − [\d.]+ = 5\.\d+\nattenuation = max\(0, 1 − t / \(2 \|T − P\|\)\) = ", gist);
        Assert.Equal(["Camera", "Ray", "Models", "Colour"], await Page.EvaluateExpressionAsync<string[]>(
            "[...document.querySelectorAll('#pixel-parts details:not([open]) summary')].map(summary => summary.textContent.split(':')[0])"));
        Assert.Null(await Page.QuerySelectorAsync("#pixel-parts details[open]"));
    }

    [BrowserFact]
    public async Task ANameThatLooksLikeMarkupIsText()
    {
        await Page.SaysAsync("<img src=x onerror=alert(1)>");
        Assert.Null(await Page.QuerySelectorAsync("img"));
    }

    [BrowserFact]
    public async Task InASmallerPictureTheNearestPixelIsExplained()
    {
        await Page.EvaluateExpressionAsync("location.hash = '#pixel=20,14'");
        await Page.ShowsAsync("#pixel-head");
        await Host.WriteSceneAsync(Ball.Replace("\"width\": 40", "\"width\": 10"));
        await Page.SaysAsync("Column 9, line 14");
    }

    [BrowserFact]
    public async Task APictureThatIsShownSmallerIsSaidToBe()
    {
        await Host.WriteSceneAsync(Ball.Replace("\"width\": 40, \"height\": 30", "\"width\": 1, \"height\": 9000"));
        await Page.SaysAsync("1 × 9000 pixels, shown as 1 × 4500");
    }

    [BrowserFact]
    public async Task KeysAloneTurnTheCameraAndExplainAPixel()
    {
        for (var i = 0; i < 40 && await FocusAsync() != "stage"; i++) await Page.PressAsync("Tab");
        Assert.Equal("stage", await FocusAsync());
        await Page.PressAsync("ArrowLeft");
        await Page.ShowsAsync("#camera-reset:not([disabled])");
        await Page.PressAsync("Enter");
        await Page.SaysAsync("Column 20, line 15");
        Assert.Empty(Host.Complaints);

        Task<string> FocusAsync() => Page.EvaluateExpressionAsync<string>("document.activeElement.id");
    }

    [BrowserFact]
    public async Task APictureThatIsDroppedIsCompared()
    {
        await Page.DropAsync(ScalarRenderer.Render(PageExtensions.Read(Ball)), () => Page.ShowsAsync("body.dropping"));
        await Page.SaysAsync("mine.png is compared: identical.");
        Assert.Null(await Page.QuerySelectorAsync("body.dropping"));
    }

    [BrowserFact]
    public async Task ThePixelUnderThePointerIsToldAgainAfterTheCameraHasTurned()
    {
        await Page.HoverOnPixelAsync(20, 14, 40, 30);
        await Page.SaysAsync("column 20, line 14 (row 15): <img");
        await Page.FocusAsync("#stage");
        for (var i = 0; i < 8; i++) await Page.PressAsync("ArrowLeft");
        await Page.ShowsAsync("#camera-reset:not([disabled])");
        await Page.SaysAsync("column 20, line 14 (row 15): the background");
    }

    [BrowserFact]
    public async Task OneFingerTurnsTwoFingersMoveAndATapExplains()
    {
        await Page.SetViewportAsync(new() { Width = 360, Height = 740, HasTouch = true });
        var touch = await Page.CreateCDPSessionAsync();
        await Page.ShowsAsync("#camera-json:not(:empty)");
        var box = await Page.BoxOfAsync("#picture");
        var (x, y) = (box.X + box.Width / 2, box.Y + box.Height / 2);
        var before = await Page.EvaluateFunctionAsync<double>(Distance);

        await DragAsync([(x, y)], [(x + 60, y)]);
        await Page.ShowsAsync("#camera-reset:not([disabled])");
        Assert.Equal(before, await Page.EvaluateFunctionAsync<double>(Distance), tolerance: 1e-3);

        await DragAsync([(x - 20, y), (x + 20, y)], [(x - 80, y), (x + 80, y)]);
        await Page.WaitForFunctionAsync($"before => ({Distance})() < 0.5 * before", before);

        await Page.Touchscreen.TapAsync(x, y);
        await Page.ShowsAsync("#pixel-head");
        Assert.Empty(Host.Complaints);

        async Task DragAsync((decimal X, decimal Y)[] from, (decimal X, decimal Y)[] to)
        {
            await SendAsync("touchStart", from);
            for (var i = 1; i <= 10; i++)
                await SendAsync("touchMove", [.. from.Zip(to, (a, b) => (a.X + (b.X - a.X) * i / 10, a.Y + (b.Y - a.Y) * i / 10))]);
            await SendAsync("touchEnd", []);
        }

        Task SendAsync(string type, (decimal X, decimal Y)[] fingers) => touch.SendAsync("Input.dispatchTouchEvent", new
        {
            type,
            touchPoints = fingers.Select((finger, id) => new { x = finger.X, y = finger.Y, id }).ToArray(),
        });
    }

    private protected override async Task<HostedPage> OpenAsync() => await ServedPage.OpenAsync(chromium);

    /// <summary>A laptop's window, or a phone.</summary>
    private async Task ResizeAsync(int width)
    {
        var isPhone = width == Phone;
        await Page.SetViewportAsync(new() { Width = width, Height = isPhone ? 740 : 900, HasTouch = isPhone, IsMobile = isPhone });
        await Page.WaitForFunctionAsync("width => innerWidth === width", width);
        await Page.ShowsPictureOfAsync(Ball);
        await Page.WaitForFunctionAsync("() => document.getElementById('model-0-rays')?.textContent.includes('%')");
    }

    /// <summary>Waits until an element is in the window, and nothing before it.</summary>
    private Task IsInSightAsync(string selector, bool isWhole = true) => Page.WaitForFunctionAsync("""
        (selector, isWhole) => {
            const element = document.querySelector(selector), { left, top, bottom } = element.getBoundingClientRect();
            const isIn = top >= 0 && top < innerHeight && (!isWhole || bottom <= innerHeight);
            return isIn && element.contains(document.elementFromPoint(left + 4, top + 4));
        }
        """, new WaitForFunctionOptions { PollingInterval = 50 }, selector, isWhole);
}
