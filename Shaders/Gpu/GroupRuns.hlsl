// Runs of equal keys in a thread group. Particles that are neighbors in memory are mostly neighbors in space, so the first thread of a
// run can add for all of it, with one atomic operation each. Include after kGroup is declared.
//
//   g_Values[thread] = value;                      // what each thread adds
//   if (!StartsRun(thread, key))
//       return;
//   FOR_REST_OF_RUN(thread, key, next)
//       value += g_Values[next];
//   END_RUN
#ifndef RILL_GROUP_RUNS_INCLUDED
#define RILL_GROUP_RUNS_INCLUDED

static const uint kNoRun = 0xFFFFFFFFu;     // key of a thread that has nothing to add

groupshared uint g_RunKeys[kGroup];

// Whether a thread is the first of a run. All threads of the group call it, with a barrier between two calls in a kernel.
bool StartsRun(uint thread, uint key)
{
    g_RunKeys[thread] = key;
    GroupMemoryBarrierWithGroupSync();
    return key != kNoRun && (thread == 0 || g_RunKeys[thread - 1] != key);
}

#define FOR_REST_OF_RUN(thread, key, next) \
    for (uint next = thread + 1; next < kGroup && g_RunKeys[next] == key; next++) \
    {

#define END_RUN }

#endif
