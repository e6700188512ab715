using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rill;

namespace Host.Experiments
{
    /// <summary>A number in a scene that a user names, "tank:8:112:0.02", with its limits.</summary>
    /// <param name="Otherwise">What it is where it is left out; null where it must be given.</param>
    sealed record GivenNumber(string Name, double Min, double Max, bool IsWhole = true, double? Otherwise = null)
    {
        /// <summary>Range of a scene's spacing, m.</summary>
        public const double MinSpacing = 1e-4, MaxSpacing = 10;

        /// <summary>s.</summary>
        public const double MaxSeconds = 3600;

        /// <summary>The numbers behind a scene's kind.</summary>
        /// <param name="example">A scene of this kind.</param>
        /// <exception cref="HostException">One is missing, no number, or out of range; the message names it, its limits and the example.</exception>
        public static double[] Parse(string text, string example, params GivenNumber[] numbers)
        {
            string[] words = text.Split(':');
            if (words.Length - 1 > numbers.Length)
                throw new HostException($"scene \"{text}\" has {words.Length - 1} numbers; give " +
                    $"{words[0]}{string.Concat(numbers.Select(number => $":<{number.Name}>"))}, as in {example}.");
            return numbers.Select((number, i) => number.Parse(text, i + 1 < words.Length ? words[i + 1] : null, example)).ToArray();
        }

        double Parse(string text, string word, string example)
        {
            if (word == null && Otherwise is double otherwise)
                return otherwise;
            bool isNumber = double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double value);
            if (isNumber && value >= Min && value <= Max && (!IsWhole || value == Math.Floor(value)))
                return value;
            throw new HostException($"scene \"{text}\": {Name} " +
                $"{(word == null ? "is missing" : $"is {(word == "" ? "empty" : word)}")}; give a " +
                $"{(IsWhole ? "whole number" : "number")} from {Text(Min)} to {Text(Max)}, as in {example}.");
        }

        /// <param name="particles">As many as the scene would have.</param>
        /// <exception cref="HostException">More than a simulation holds.</exception>
        public static void CheckParticles(string text, double particles)
        {
            if (!(particles <= SolverLayout.MaxCapacity))
                throw new HostException(string.Create(CultureInfo.InvariantCulture,
                    $"scene \"{text}\" is " +
                    $"{(particles < 1e15 ? particles.ToString("N0", CultureInfo.InvariantCulture) : particles.ToString("0e0", CultureInfo.InvariantCulture))} particles; a simulation holds {SolverLayout.MaxCapacity:N0}. Give smaller numbers."));
        }

        /// <summary>An option that has to lie within limits.</summary>
        /// <exception cref="HostException">It does not.</exception>
        public static void CheckOption(string name, double value, double min, double max)
        {
            if (!(value >= min && value <= max))
                throw new HostException($"{name} {Text(value)}: give {Text(min)} to {Text(max)}.");
        }

        /// <summary>Clamps what the solver would not take, and reports it.</summary>
        public static void Clamp(string command, ref SolverSettings settings, ref FluidMaterial material)
        {
            if (!settings.Validate(out string problem) | !material.Validate(out string materialProblem))
                Console.Error.WriteLine($"rill: {command}: {problem} {materialProblem}".Replace(":  ", ": ", StringComparison.Ordinal).TrimEnd());
        }

        static string Text(double value) => value.ToString(Math.Abs(value) >= 1000 ? "#,0.######" : "0.######", CultureInfo.InvariantCulture);
    }
}
