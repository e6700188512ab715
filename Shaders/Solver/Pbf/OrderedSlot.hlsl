// Slot of a particle among those of its cell. Include after _CellStarts and _Order are declared.
#ifndef RILL_ORDERED_SLOT_INCLUDED
#define RILL_ORDERED_SLOT_INCLUDED

// By id: arrival numbers depend on the order in which atomics land.
uint OrderedSlot(uint id, uint cell)
{
    uint first = _CellStarts[cell];
    uint end = _CellStarts[cell + 1];
    uint ordered = first;
    for (uint other = first; other < end; other++)
        ordered += _Order[other].y < id ? 1 : 0;
    return ordered;
}

#endif
