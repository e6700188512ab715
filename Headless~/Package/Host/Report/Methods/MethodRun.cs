using System;
using System.Collections.Generic;
using System.Linq;
using Host.Report.ErrorTime;

namespace Host.Report.Methods
{
    /// <summary>A run of the study of methods: an iteration in one scene, with the coarse grid or without.</summary>
    sealed class MethodRun
    {
        public const string Jacobi = "Jacobi", Substeps = "substeps";

        // The study's names, in the page's order. Settings of the grid itself are left out.
        static readonly (string Study, string Method)[] Studies =
        {
            ("omega", "relaxation ω"), ("neighbor-mean", "neighbors' mean (eq. 4.14)"), ("chebyshev", "Chebyshev"), ("srj", "scheduled relaxation"),
            ("nesterov", "Nesterov"), ("gauss-seidel", "colored Gauss-Seidel"), ("substeps", Substeps),
        };

        readonly ReportTable.Row row;

        MethodRun(ReportTable.Row row, string method) => (this.row, Method) = (row, method);

        /// <summary>All methods, Jacobi first.</summary>
        public static IEnumerable<string> Methods => Studies.Select(study => study.Method).Prepend(Jacobi);

        /// <summary>The runs of the methods. The first study ran while the GPU raised its clock and is left out; others have its settings.</summary>
        public static List<MethodRun> All(ReportTable table)
            => (from row in table.Rows
                let method = MethodOf(row)
                where method != null
                select new MethodRun(row, method)).ToList();

        static string MethodOf(ReportTable.Row row)
        {
            string method = Studies.FirstOrDefault(study => study.Study == row["study"]).Method;
            bool isJacobi = row["study"] == "omega" && (float)row.Number("relaxation") == SweepSetting.UsualRelaxation
                || row["study"] == "substeps" && row["substeps"] == "1";
            return isJacobi ? Jacobi : method;
        }

        public string Method { get; }
        public string Scene => row["scene"];
        public double Particles => row.Number("particles");
        /// <summary>Whether the step has two coarse solves.</summary>
        public bool HasGrid => row["two_level"] == "1";
        public int SubstepCount => (int)row.Number("substeps");
        public int Iterations => (int)row.Number("iterations");
        // The dam is judged while it moves, still water at the end.
        bool Moves => Scene == "dam";
        /// <summary>C+; NaN where the run left no number.</summary>
        public double Error => row.Number(Moves ? "error_moving" : "error_settled");
        /// <summary>m/s.</summary>
        public double Noise => row.Number(Moves ? "jitter" : "speed");
        public double Milliseconds => row.Number(Moves ? "ms_moving" : "ms_settled");
        /// <summary>Whether the run stands and kept its energy.</summary>
        public bool Holds => row["state"] == "stands" && row.Number("energy") <= SweepResult.MaxEnergy;

        /// <summary>"1 x 4, ρ 0.8".</summary>
        public string Setting => $"{SubstepCount} x {Iterations}" + row["study"] switch
        {
            "omega" when Method != Jacobi => $", ω {row["relaxation"]}",
            "neighbor-mean" => $", fraction {row["value"]}",
            "chebyshev" => $", ρ {row["value"]}",
            "srj" => $", {(row["label"].Length > 0 ? row["label"] : "from " + row["value"])}",
            "gauss-seidel" => $", {row["series"].Replace("two-level ", "").Split(" k ")[0]}, ω {row["value"]}",
            "nesterov" => row["series"].Contains("without") ? ", no restart" : "",
            _ => "",
        };
    }
}
