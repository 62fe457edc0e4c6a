#include "tag_map.h"

namespace SPHTM_NS {

void TagMap::move_to(Backend &b)
{
  backend = &b;
  loops = &ListLoops::of(b);
  for (auto *a : {&tag, &first, &next}) a->move_to(b);
  gone.move_to(b);
}

int TagMap::append(int entries)
{
  const int at = on ? n : 0;
  if (!on) owned_before = 0;
  if (at + entries > (int) tag.size()) tag.resize(2 * (at + entries));
  n = at + entries;
  on = true;
  return at;
}

void TagMap::begin(const int *loop_tags, int owned, int owned_and_ghosts)
{
  append(owned_and_ghosts);
  owned_before = owned;
  backend->copy(tag.loop_write(), loop_tags, owned_and_ghosts * sizeof(int));
}

bool TagMap::same_indices(const int *loop_tags, int owned) const
{
  return on && n == owned && owned_before == owned &&
         loops->differing(*backend, owned, {tag.loop_read(), loop_tags}, 0u) == 0;
}

void TagMap::locate(tm_tag_map_args &a, int owned_and_ghosts, bool finds_gone)
{
  a.entry_tag = tag.loop_read();
  a.largest = loops->largest(*backend, owned_and_ghosts, {a.tag, nullptr}, 0u);
  first.make_room(true, (size_t) a.largest + 1);
  next.make_room(true, (size_t) owned_and_ghosts + 1);
  a.first = first.loop_write();
  a.next = next.loop_write();
  backend->zero(a.first, ((size_t) a.largest + 1) * sizeof(int));
  loops->chain_tags(*backend, owned_and_ghosts, a);
  gone.make_room(finds_gone, n + 1);
  a.gone = gone.loop_write();
  if (a.gone) backend->fill(a.gone, 0, n);
}

std::vector<int> TagMap::gone_tags()
{
  std::vector<int> tags;
  const unsigned char *is_gone = gone.host_read();
  const int *of = tag.host_read();
  for (int k = 0; k < n; k++)
    if (is_gone[k]) tags.push_back(of[k]);
  return tags;
}

double TagMap::bytes() const { return tag.bytes() + first.bytes() + next.bytes() + gone.bytes(); }

}    // namespace SPHTM_NS
