using System.IO;

namespace Host.Report
{
    /// <summary>Folders of a report's tables, pictures and page.</summary>
    /// <param name="ImageLink">From the page to the pictures.</param>
    sealed record ReportFolders(string Data, string Page, string ImageLink)
    {
        public const string DataLink = "data";

        public string PageFolder => Path.GetDirectoryName(Page);
        public string Images => Path.Combine(PageFolder, ImageLink);
        /// <summary>Folder that the page's links to tables lead to.</summary>
        public string LinkedData => Path.Combine(PageFolder, DataLink);

        /// <param name="page">Null: report.md in the folder itself. Else a page among others: its pictures get a folder of their own.</param>
        public static ReportFolders Of(string folder, string page) => page == null
            ? new ReportFolders(Path.Combine(folder, DataLink), Path.Combine(folder, "report.md"), "images")
            : new ReportFolders(Path.Combine(folder, DataLink), Path.GetFullPath(page), "images/report");
    }
}
