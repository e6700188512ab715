using System;
using System.Collections.Generic;

namespace Host.Output
{
    /// <summary>Measurements of a scene once a step: columns of statistics.csv, plots of them, and settings worth naming.</summary>
    interface IRunProbe
    {
        /// <summary>Names as in the CSV's first line, with the unit: "density_error_mean", "energy_J".</summary>
        string[] Columns { get; }

        /// <summary>Writes a value for each column, NaN where there is none (yet). Called after each step.</summary>
        void Sample(double time, double[] values);

        Plot[] Plots => Array.ConvertAll(Columns, column => new Plot(column, column, column, column));

        /// <summary>Lines to print when the run is over.</summary>
        IEnumerable<string> Summary => Array.Empty<string>();

        /// <summary>Rows of the page's settings table.</summary>
        IEnumerable<(string Name, string Value)> Settings => Array.Empty<(string, string)>();
    }
}
