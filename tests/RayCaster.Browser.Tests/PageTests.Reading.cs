using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>Somebody reads, on a laptop and on a phone, while the picture stays in sight.</summary>
public abstract partial class PageTests
{
    private const int Laptop = 1400, Phone = 360;

    /// <summary>The text that a number is broken in, or nothing.</summary>
    private const string BrokenNumbers = """
        () => {
            const broken = [], range = document.createRange();
            const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
            while (texts.nextNode()) {
                const node = texts.currentNode;
                if (!node.parentElement.checkVisibility()) continue;
                for (const { index, 0: number } of node.data.matchAll(/[−-]?\d[\d.]*(e[−-]?\d+)?/g)) {
                    range.setStart(node, index);
                    range.setEnd(node, index + number.length);
                    if (new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size > 1) broken.push(node.data);
                }
            }
            return broken.join('\n');
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

    [BrowserTheory]
    [InlineData(Laptop)]
    [InlineData(Phone)]
    public async Task NothingMovesDuringADrag(int width)
    {
        await ResizeAsync(width);
        await Page.HoverOnPixelAsync(20, 14, 40, 30);
        await Page.SaysAsync("column 20, line 14 (row 15)");
        await Page.EvaluateExpressionAsync($$"""
            {
                const places = () => {{Places}};
                const before = places();
                window.moved = [];
                window.moving = 0;
                document.getElementById('stage').addEventListener('frame', ({ detail }) => {
                    if (detail.isFinal) return;
                    moving++;
                    places().forEach((place, i) => { if (place !== before[i]) moved.push(`${before[i]}, then ${place}`); });
                });
            }
            """);
        await Page.Mouse.DownAsync();
        var box = await Page.BoxOfAsync("#picture");
        var step = 0;
        await PageExtensions.UntilAsync(async () =>
        {
            await Page.Mouse.MoveAsync(box.X + ++step % 100, box.Y + 60);
            return await Page.EvaluateExpressionAsync<int>("moving") >= 3;
        });
        Assert.Empty(await Page.EvaluateExpressionAsync<string[]>("moved"));
        await Page.Mouse.UpAsync();
    }

    [BrowserTheory]
    [InlineData(Laptop)]
    [InlineData(Phone)]
    public async Task NoLineIsBrokenInsideANumberAndEachKeepsItsIndentation(int width)
    {
        await ResizeAsync(width);
        await Page.FocusAsync("#stage");
        await Page.PressAsync("ArrowLeft");
        await Page.ShowsAsync("#camera-reset:not([disabled])");
        await Page.ExplainAsync();
        await Page.DropWrongAsync(40, 30);
        await Page.EvaluateExpressionAsync("document.querySelectorAll('details').forEach(part => { part.open = true; })");
        Assert.Equal("", await Page.EvaluateFunctionAsync<string>(BrokenNumbers));
        Assert.Equal("", await Page.EvaluateFunctionAsync<string>("""
            () => [...document.querySelectorAll('#pixel .line:not(.row), #compare-text .line:not(.row)')].filter(line => {
                const range = document.createRange(), indent = /^ */.exec(line.textContent)[0].length;
                range.setStart(line.firstChild, indent);
                range.setEnd(line.firstChild, line.firstChild.length);
                const [first, ...others] = [...range.getClientRects()].filter(box => box.width > 0).map(({ left }) => left);
                return others.some(left => left <= first);
            }).map(line => line.textContent).join('')
            """));
    }

    [BrowserFact]
    public async Task TheCamerasNumbersHaveAsManyDigitsAsMatter()
    {
        await Page.FocusAsync("#stage");
        await Page.PressAsync("ArrowLeft");
        await Page.ShowsAsync("#camera-reset:not([disabled])");
        var numbers = await Page.TextOfAsync("#camera-json");
        Assert.Matches("""^"position": \[(-?\d{1,2}(\.\d{1,3})?(, )?){3}\],\n"target": \[-6, 0, 0\],\n"fovY": 45$""", numbers);
    }

    [BrowserTheory]
    [InlineData(Laptop)]
    [InlineData(Phone)]
    public async Task TheFocusRingSurroundsThePictureOnly(int width)
    {
        await ResizeAsync(width);
        await Page.FocusAsync("#stage");
        await Page.PressAsync("ArrowLeft");
        Assert.Equal("solid", await Page.EvaluateExpressionAsync<string>("getComputedStyle(document.getElementById('stage')).outlineStyle"));
        var (ring, picture) = (await Page.BoxOfAsync("#stage"), await Page.BoxOfAsync("#picture"));
        Assert.Equal((ring.X, ring.Y, ring.Width, ring.Height), (picture.X, picture.Y, picture.Width, picture.Height));
        Assert.Equal(40.0 / 30, (double)(ring.Width / ring.Height), tolerance: 0.01);
    }

    [BrowserTheory]
    [InlineData(Laptop, "Click a pixel", "Tap a pixel")]
    [InlineData(Phone, "Tap a pixel", "Click a pixel")]
    public async Task TheHelpSpeaksOfWhatOneHas(int width, string told, string untold)
    {
        await ResizeAsync(width);
        var text = await Page.TextOfAsync("body");
        Assert.Contains(told, text);
        Assert.DoesNotContain(untold, text);
        Assert.Equal(width == Laptop, text.Contains("wheel") && text.Contains("Arrow keys") && text.Contains("anywhere on the page"));
        Assert.Equal(width == Phone, text.Contains("One finger turns the camera."));
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
    public async Task ThePartsStandInTheSameOrderOnEachHost()
    {
        await Page.ClickOnPixelAsync(20, 14, 40, 30);
        await Host.WriteSceneAsync("{");
        await Page.ShowsAsync("#problems");
        string[] both = ["picture", "tools", "problems", "camera", "pixel", "models", "comparison"];
        var shown = await Page.EvaluateExpressionAsync<string[]>("""
            [...document.querySelectorAll('#picture, main section')].filter(part => part.checkVisibility()).map(part => part.id)
            """);
        Assert.Equal(both, shown.Where(part => part != "scene"));
    }

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
