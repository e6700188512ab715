using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Connections of a fluid, from whose neighbors it takes particles once a frame, before its steps.</summary>
    sealed class ConnectionInputs
    {
        readonly FluidSimulation fluid;
        readonly FluidConnection[] connections = new FluidConnection[ParticleTransfer.MaxTransfers];    // by their transfers' numbers
        StepConnections neighbors;
        int count, steppedInFrame = -1, begunInFrame = -1;

        public ConnectionInputs(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Neighbors of the coming steps; null for none.</summary>
        public StepConnections Neighbors => neighbors != null && neighbors.neighborCount > 0 ? neighbors : null;

        /// <summary>Adds an end of a connection.</summary>
        /// <returns>False where there are too many.</returns>
        public bool Connect(FluidConnection connection)
        {
            int number = Array.IndexOf(connections, null);
            if (number < 0)
                return false;
            connections[number] = connection;
            count++;
            return true;
        }

        public void Disconnect(FluidConnection connection)
        {
            int number = Array.IndexOf(connections, connection);
            if (number < 0)
                return;
            connections[number] = null;
            count--;
            fluid.Solver?.ResetTransfer(number);
        }

        /// <summary>Returns a number of what came over a connection, as far as it has come back.</summary>
        public int Transferred(FluidConnection connection, TransferWord word)
        {
            int number = Array.IndexOf(connections, connection);
            return fluid.Solver != null && number >= 0 ? fluid.Solver.Transferred(number, word) : 0;
        }

        /// <summary>Finds the neighbors of the coming steps, where there are any that run.</summary>
        public void Collect()
        {
            if (count == 0)
            {
                neighbors = null;
                return;
            }
            neighbors ??= new StepConnections();
            neighbors.Clear();
            for (int number = 0; number < connections.Length; number++)
            {
                FluidConnection connection = connections[number];
                FluidSimulation other = connection != null ? connection.Other(fluid) : null;
                if (other == null || other.Solver == null || other.IsPlayedBack || !fluid.Support.HasBesideSteps(Features.Transfer))
                    continue;
                if (!connection.CanFlow())
                    continue;
                PbfSolver solver = fluid.Solver, otherSolver = other.Solver;
                TransferRegion toThis = connection.RegionTo(fluid), toOther = connection.RegionTo(other);
                connection.State.PrepareExchange(fluid, other, toThis, toOther);
                neighbors.AddNeighbor(new StepNeighbor { solver = otherSolver, region = toThis });
                if (connection.State.TakenInFrame == Time.frameCount)
                    continue;       // the other has taken for both
                ConnectionInputs others = other.Inputs.Connections;
                toThis.number = number;
                toThis.stepsAhead = solver.StepIndex - otherSolver.StepIndex;
                toOther.number = Array.IndexOf(others.connections, connection);
                toOther.stepsAhead = otherSolver.StepIndex - solver.StepIndex;
                // One that took no step with this one last time is paused, or slower: it takes when it steps. So does one that has already
                // begun this frame, or it would hold ghosts until the next.
                bool isMutual = others.steppedInFrame == steppedInFrame && others.begunInFrame != Time.frameCount && !other.Paused
                    && !other.Resolution.IsPending;
                if (isMutual)
                    connection.State.TakenInFrame = Time.frameCount;
                neighbors.Add(new StepConnection
                {
                    neighbor = otherSolver, region = toThis, back = toOther, isMutual = isMutual, copiesOnly = other.Resolution.IsPending,
                    frame = Time.frameCount,
                });
            }
        }

        /// <summary>Lets the connections go on with the same water in another solver.</summary>
        public void Continue(PbfSolver before, PbfSolver next)
        {
            foreach (FluidConnection connection in connections)
                if (connection != null)
                    connection.State.Continue(before, next);
        }

        /// <summary>Begins a frame, whether or not it takes steps.</summary>
        public void BeginFrame() => begunInFrame = Time.frameCount;

        /// <summary>Notes that this frame takes steps.</summary>
        public void MarkSteps() => steppedInFrame = Time.frameCount;

        /// <summary>Removes ghosts in a frame without steps, for which a neighbor may have given some.</summary>
        public void DropGhosts()
        {
            if (fluid.Solver == null || !fluid.Solver.HasGhosts)
                return;
            fluid.Commands.Clear();
            fluid.Solver.RecordGhostRemoval(fluid.Commands);
            Graphics.ExecuteCommandBuffer(fluid.Commands);
        }

        /// <summary>Requests what came over the connections, after the steps of a frame were executed, and logs what the last numbers
        /// say.</summary>
        public void RequestCounts()
        {
            if (Neighbors == null)
                return;
            foreach (FluidConnection connection in connections)
                if (connection != null)
                    connection.ReportWaiting();
            fluid.Solver.RequestTransferred();
        }

        public void Release() => neighbors = null;
    }
}
