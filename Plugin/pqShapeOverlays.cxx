#include "pqShapeOverlays.h"

#include <algorithm>
#include <cstddef>

pqShapeOverlays::pqShapeOverlays(const std::function<void()>& draw,
  const std::function<bool(unsigned long)>& takeEvent, const std::function<void()>& leave)
  : Draw(draw)
  , TakeEvent(takeEvent)
  , Leave(leave)
  , Current(this->Add())
  , Last(this->Current)
{
}

pqShapeOverlay* pqShapeOverlays::Add()
{
  const std::size_t i = this->Items.size();
  this->Items.push_back(
    std::make_unique<pqShapeOverlay>([this, i] { this->OnDraw(this->Items[i].get()); },
      [this, i](unsigned long event) { return this->OnEvent(this->Items[i].get(), event); }));
  return this->Items.back().get();
}

bool pqShapeOverlays::IsAttached() const
{
  return std::any_of(this->Items.begin(), this->Items.end(),
    [](const auto& overlay) { return overlay->IsAttached(); });
}

std::vector<pqView*> pqShapeOverlays::GetViews() const
{
  std::vector<pqView*> views;
  for (const auto& overlay : this->Items)
  {
    if (overlay->GetView())
    {
      views.push_back(overlay->GetView());
    }
  }
  return views;
}

bool pqShapeOverlays::DetachExcept(const std::vector<pqView*>& views)
{
  bool changed = false;
  for (const auto& overlay : this->Items)
  {
    if (overlay->IsAttached() &&
      std::find(views.begin(), views.end(), overlay->GetView()) == views.end())
    {
      overlay->Detach();
      changed = true;
    }
  }
  return changed;
}

bool pqShapeOverlays::Attach(const std::vector<pqView*>& views)
{
  bool changed = this->DetachExcept(views);
  const std::vector<pqView*> attached = this->GetViews();
  for (pqView* view : views)
  {
    if (pqShapeOverlay::CanAttach(view) &&
      std::find(attached.begin(), attached.end(), view) == attached.end())
    {
      const auto unused = std::find_if(this->Items.begin(), this->Items.end(),
        [](const auto& overlay) { return !overlay->IsAttached(); });
      pqShapeOverlay* overlay = unused == this->Items.end() ? this->Add() : unused->get();
      overlay->Attach(view);
      changed = true;
    }
  }
  const auto first = std::find_if(this->Items.begin(), this->Items.end(),
    [](const auto& overlay) { return overlay->IsAttached(); });
  if (!this->Last->IsAttached() && first != this->Items.end())
  {
    this->Last = first->get();
    this->Current = this->Last;
  }
  return changed;
}

void pqShapeOverlays::OnDraw(pqShapeOverlay* overlay)
{
  if (!this->Last->IsAttached())
  {
    this->Last = overlay;
  }
  this->Current = overlay;
  this->Draw();
  this->Current = this->Last;
}

bool pqShapeOverlays::OnEvent(pqShapeOverlay* overlay, unsigned long event)
{
  if (overlay != this->Last)
  {
    this->Leave();
    this->Last = overlay;
    this->Current = overlay;
  }
  return this->TakeEvent(event);
}
