using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;

namespace Host.Manual
{
    /// <summary>The manual as HTML: its pages, the scripting reference, and the pages that the question marks of components open. Style and
    /// search are in <c>Documentation~/style</c>.</summary>
    public sealed class ManualBuilder
    {
        /// <summary>Assemblies whose public types the scripting reference has. Those of the render pipelines are compiled against stand-ins and stay
        /// out.</summary>
        public static readonly string[] Assemblies = { "Rill", "Rill.Physics", "Rill.Terrain", "Rill.TerrainPhysics", "Rill.Timeline", "Rill.Testing",
            "Rill.Editor" };

        const string TableOfContents = "TableOfContents.md", Reference = "reference";

        readonly SortedDictionary<string, string> files = new(StringComparer.OrdinalIgnoreCase);
        readonly SearchDocuments search = new();
        readonly Action<string> fault;
        readonly ApiLibrary library;
        readonly List<HelpTopic> topics;
        readonly List<MarkdownPage> pages;
        readonly Contents contents;
        readonly PageFrame frame;

        ManualBuilder(string root, string assemblies, Action<string> fault)
        {
            this.fault = fault;
            library = new ApiLibrary(assemblies, Assemblies);
            topics = library.Types.Select(HelpTopic.Of).Where(topic => topic != null).ToList();
            string folder = Path.Combine(root, "Documentation~");
            pages = Directory.GetFiles(folder, "*.md").Where(file => Path.GetFileName(file) != TableOfContents)
                .OrderBy(file => file, StringComparer.Ordinal)
                .Select(file => new MarkdownPage(Path.GetFileNameWithoutExtension(file), File.ReadAllText(file))).ToList();
            contents = new Contents(File.ReadAllText(Path.Combine(folder, TableOfContents)).Replace("\r\n", "\n"));
            using JsonDocument manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(root, "package.json")));
            frame = new PageFrame(manifest.RootElement.GetProperty("displayName").GetString(),
                manifest.RootElement.GetProperty("version").GetString());
        }

        /// <summary>Returns the files of the manual by their paths below its folder, with '/'.</summary>
        /// <param name="root">The package's root.</param>
        /// <param name="assemblies">Folder of the package's compiled assemblies and those that they reference, with their documentation.</param>
        /// <param name="fault">Takes what is wrong with the pages, a sentence each.</param>
        public static IReadOnlyDictionary<string, string> Build(string root, string assemblies, Action<string> fault)
            => new ManualBuilder(root, assemblies, fault).Build();

        IReadOnlyDictionary<string, string> Build()
        {
            foreach (MarkdownPage page in pages)
                AddPage(page);
            AddApi();
            foreach (HelpTopic topic in topics)
                AddHelp(topic);
            files.Add("search-documents.js", search.Script());
            return files;
        }

        void AddPage(MarkdownPage page)
        {
            int at = contents.Entries.FindIndex(entry => entry.Address == page.Address);
            files.Add(page.Address, frame.Around(new PageContent
            {
                Address = page.Address,
                Title = page.Title,
                Body = page.Body(library.AddressOfName, heading => Below(page, heading)),
                Navigation = contents.Groups.Select(group => new LinkGroup(group.Title, group.Entries.Select(Link).ToList())).ToList(),
                Headings = page.Headings,
                Previous = at > 0 ? Link(contents.Entries[at - 1]) : null,
                Next = at >= 0 && at + 1 < contents.Entries.Count ? Link(contents.Entries[at + 1]) : null,
            }));
            foreach (PageSection section in page.Sections())
                search.Add(section.Heading.Level == 1 ? page.Address : $"{page.Address}#{section.Heading.Id}", section.Heading.Text,
                    section.Heading.Level == 1 ? "" : page.Title, section.Text);
        }

        static PageLink Link(ContentsEntry entry) => new(Html.Escape(entry.Title), entry.Address);

        // Links from a component's section to its fields and its code, and back.
        string Below(MarkdownPage page, PageHeading heading)
        {
            HelpTopic topic = page.Name == Reference ? topics.Find(known => known.Title != null && Anchor.Of(known.Title) == heading.Id)
                : topics.Find(known => known.Page == page.Name && known.Section == heading.Id);
            if (topic == null)
                return null;
            string own = page.Name == Reference ? $"<a href=\"{topic.Address}\">Guide</a>"
                : topic.Fields != null ? $"<a href=\"{topic.Fields}\">Fields</a>" : "";
            return $"<p class=\"see\">{own} <a href=\"{topic.Type.Address}\">Scripting</a></p>";
        }

        void AddApi()
        {
            var apiPages = new ApiPage(library);
            files.Add(ApiIndex.Address, frame.Around(new PageContent
            {
                Address = ApiIndex.Address, Title = ApiIndex.Title, Body = ApiIndex.Body(library, apiPages),
                Navigation = ApiIndex.Navigation(library, null), Headings = ApiIndex.Headings(library),
            }));
            foreach (ApiType type in library.Types)
            {
                files.Add(type.Address, frame.Around(new PageContent
                {
                    Address = type.Address, Title = type.Name, Body = apiPages.Body(type, topics.Find(topic => topic.Type == type)),
                    Navigation = ApiIndex.Navigation(library, type), Headings = apiPages.Headings(type),
                }));
                search.Add(type.Address, type.Name, ApiIndex.Title, apiPages.SearchText(type));
            }
        }

        void AddHelp(HelpTopic topic)
        {
            MarkdownPage page = pages.Find(known => known.Name == topic.Page);
            PageHeading heading = page?.Headings.FirstOrDefault(known => known.Id == topic.Section);
            if (heading == null)
                fault($"{topic.Type.Name} has [ManualPage(\"{topic.Page}\", \"{topic.Section}\")], and Documentation~/{topic.Page}.md has no " +
                    "heading of that name: write the heading, or name another.");
            else
                files[topic.Redirect] = topic.RedirectHtml(heading.Text);
        }
    }
}
