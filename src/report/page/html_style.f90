!> Style of the page of a run: on a screen, on a phone, on paper.
module dg_html_style
   use dg_html_text, only: css_string
   use dg_line_list, only: add_line, line_list_type
   use dg_page_script, only: style_lines
   implicit none
   private
   public :: append_style

   !> Plain, no colour that means anything alone. A table wider than the window scrolls in its own box, which has a coloured
   !> right edge until its end is seen.
   character(*), parameter :: style(*) = [character(128) :: &
      'body{font:15px/1.45 "DejaVu Sans",Arial,sans-serif;color:#222;max-width:1180px;margin:0 auto;padding:1em 1.5em}', &
      'h1{font-size:1.6em;margin:.3em 0}h2{font-size:1.25em;margin-top:2em;border-bottom:1px solid #bbb}', &
      'h3{font-size:1.05em;margin-top:1.6em}h1,h2,h3,p,li{overflow-wrap:anywhere}', &
      'table{border-collapse:collapse;font-size:.82em;font-variant-numeric:tabular-nums}.wide{overflow-x:auto}', &
      ':root{--back:#fff;--edge:#0072B2}.wide{background:linear-gradient(270deg,var(--back) 1.2em,transparent) right/2.4em 100%', &
      'no-repeat local,linear-gradient(270deg,var(--edge),transparent) right/.7em 100% no-repeat}', &
      'th,td{padding:.22em .6em;text-align:right;border-bottom:1px solid #ddd}td.text,th.text{text-align:left}', &
      'td.text{white-space:nowrap}td.long{white-space:normal;min-width:18em}', &
      'th{vertical-align:bottom;border-bottom:2px solid #888;font-weight:600;line-height:1.2}small{font-weight:400}', &
      'tr.bad td,b.no{color:#a33}', &
      '.note{border-left:4px solid #0072B2;padding:.3em .8em;background:#f3f7fa}.warn{border-color:#D55E00;background:#fdf4ee}', &
      'pre{font-size:.78em;background:#f6f6f6;padding:.8em;overflow-x:auto;line-height:1.35}svg{width:100%;height:auto}', &
      'svg text{font-family:"DejaVu Sans",Arial,sans-serif}figure{margin:1em 0;break-inside:avoid}', &
      'figcaption{font-size:.85em;color:#555}ul{margin:.4em 0}', &
      'details,.data{font-size:.9em;margin:.3em 0}summary{cursor:pointer;color:#0072B2}a{color:#0072B2}', &
      '.fold{font-size:1em}.fold>summary{font-size:1.1em;font-weight:600}']

   !> A screen that is set dark. Pictures are turned about in lightness, so that paper becomes black and colours stay what they are.
   character(*), parameter :: dark(*) = [character(128) :: &
      '@media screen and (prefers-color-scheme:dark){:root{color-scheme:dark;--back:#14181c}', &
      'body{background:#14181c;color:#dde2e6}h2{border-color:#555}th,td{border-color:#333a40}th{border-color:#777}', &
      '.note{background:#1b2a35}.warn{background:#35261b}', &
      'pre{background:#1c2126}tr.bad td,b.no{color:#ff9c8c}figcaption{color:#aab2b9}summary,a{color:#6cb8e6}', &
      'th:first-child,td:first-child{background:#14181c}svg{filter:invert(.92) hue-rotate(180deg)}}']

   !> A phone: the first column stays while the others scroll.
   character(*), parameter :: narrow(*) = [character(128) :: &
      '@media screen and (max-width:700px){body{padding:.6em}td.long{min-width:12em}', &
      'th:first-child,td:first-child{position:sticky;left:0;background:#fff}', &
      'td.text:first-child{white-space:normal;min-width:5em;max-width:9em}td,th{overflow-wrap:break-word}', &
      'figure{overflow-x:auto;margin:1em 0}figure svg{min-width:46em}.live svg{min-width:0}}']

   !> Paper lies broad, so that all columns have room; what is longer is wrapped, for paper does not scroll. A heading stays with
   !> what it stands over. 135 mm leave room for two headings and a caption on A4 and Letter.
   character(*), parameter :: paper(*) = [character(128) :: &
      '@media print{body{max-width:none;padding:0;font-size:9.5pt}h1,h2,h3,h2+p,h2+p+p{break-after:avoid}h2{margin-top:1.4em}', &
      'p,li{orphans:3;widows:3}.wide{overflow:visible;background:none}table{font-size:8pt;max-width:100%}', &
      'th,td{padding:.2em .4em}', &
      'thead{display:table-header-group}tr{break-inside:avoid}td.text{white-space:normal;overflow-wrap:break-word}', &
      'td.long{min-width:0}td.text:first-child{overflow-wrap:anywhere;min-width:10em}', &
      'pre{font-size:8pt;overflow:visible;white-space:pre-wrap;overflow-wrap:anywhere;background:none;padding:0}', &
      'figure{margin:.4em 0}svg{max-height:135mm}.note{break-inside:avoid}}']

contains

   !> The style with its element. Each sheet has `title` and `stamp` above, its number below, in browsers that know margin boxes of
   !> pages; others leave them out.
   pure subroutine append_style(lines, title, stamp)
      type(line_list_type), intent(inout) :: lines
      character(*), intent(in) :: title, stamp
      integer :: i
      call add_line(lines, '<style>')
      do i = 1, size(style)
         call add_line(lines, trim(style(i)))
      end do
      do i = 1, size(narrow)
         call add_line(lines, trim(narrow(i)))
      end do
      do i = 1, size(dark)
         call add_line(lines, trim(dark(i)))
      end do
      call add_line(lines, '@page{size:landscape;margin:16mm 12mm 14mm;font:8pt "DejaVu Sans",Arial,sans-serif;color:#555;')
      call add_line(lines, '@top-left{content:'//css_string(title)//';width:66%;text-align:left}')
      call add_line(lines, '@top-right{content:'//css_string(stamp)//';width:34%;text-align:right}')
      call add_line(lines, '@bottom-right{content:counter(page)" / "counter(pages)}}')
      do i = 1, size(paper)
         call add_line(lines, trim(paper(i)))
      end do
      do i = 1, size(style_lines)
         call add_line(lines, trim(style_lines(i)))
      end do
      call add_line(lines, '</style>')
   end subroutine append_style
end module dg_html_style
